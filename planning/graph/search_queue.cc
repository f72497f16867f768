#include "planning/graph/search_queue.h"

#include <algorithm>

namespace regista::graph {
namespace {

/// So many are looked through as fast as a heap is put in order.
constexpr std::size_t kFew = 16;

bool later(const SearchQueue::Entry& a, const SearchQueue::Entry& b) {
  if (a.estimate_m != b.estimate_m) return a.estimate_m > b.estimate_m;
  return a.is_arrival != b.is_arrival ? a.is_arrival : a.index > b.index;
}

}  // namespace

void SearchQueue::push(const Entry& entry) {
  entries_.push_back(entry);
  if (is_heap_) {
    std::push_heap(entries_.begin(), entries_.end(), later);
  } else if (entries_.size() > kFew) {
    std::make_heap(entries_.begin(), entries_.end(), later);
    is_heap_ = true;
  }
}

SearchQueue::Entry SearchQueue::pop() {
  if (is_heap_) {
    std::pop_heap(entries_.begin(), entries_.end(), later);
    is_heap_ = entries_.size() > kFew / 2;
  } else {
    std::swap(entries_[first_of_few()], entries_.back());
  }
  const Entry first = entries_.back();
  entries_.pop_back();
  return first;
}

/// Which one is the least nobody can foresee: no branch depends on it.
std::size_t SearchQueue::first_of_few() const {
  std::size_t first = 0;
  double least_m = entries_[0].estimate_m;
  for (std::size_t i = 1; i < entries_.size(); ++i) {
    const double estimate_m = entries_[i].estimate_m;
    bool is_before = estimate_m < least_m;
    if (estimate_m == least_m) is_before = later(entries_[first], entries_[i]);
    first = is_before ? i : first;
    least_m = std::min(estimate_m, least_m);
  }
  return first;
}

}  // namespace regista::graph
