#include "planning/graph/search_queue.h"

#include <algorithm>

namespace regista::graph {
namespace {

bool later(const SearchQueue::Entry& a, const SearchQueue::Entry& b) {
  if (a.estimate_m != b.estimate_m) return a.estimate_m > b.estimate_m;
  return a.is_arrival != b.is_arrival ? a.is_arrival : a.index > b.index;
}

}  // namespace

void SearchQueue::push(const Entry& entry) {
  heap_.push_back(entry);
  std::push_heap(heap_.begin(), heap_.end(), later);
}

SearchQueue::Entry SearchQueue::pop() {
  const Entry first = heap_.front();
  std::pop_heap(heap_.begin(), heap_.end(), later);
  heap_.pop_back();
  return first;
}

}  // namespace regista::graph
