// The order in which a search looks at things decides its answer among equals, so it must be the same every time.
#include "planning/graph/search_queue.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <tuple>

namespace regista::graph {
namespace {

TEST_CASE("a search queue gives the least estimate first, of equal ones legs, then the lesser index") {
  std::mt19937_64 random(72);
  const auto key = [](const SearchQueue::Entry& entry) {
    return std::tuple(entry.estimate_m, entry.is_arrival, entry.index);
  };
  const auto earlier = [&](const SearchQueue::Entry& a, const SearchQueue::Entry& b) { return key(a) < key(b); };
  SearchQueue queue;
  std::vector<SearchQueue::Entry> sorted;
  for (int step = 0; step < 5000; ++step) {
    if (random() % 3 != 0 || sorted.empty()) {
      const SearchQueue::Entry entry{static_cast<double>(random() % 20), static_cast<std::uint32_t>(random() % 50),
                                     random() % 2 == 0};
      queue.push(entry);
      sorted.insert(std::upper_bound(sorted.begin(), sorted.end(), entry, earlier), entry);
      continue;
    }
    INFO("step " << step << " of seed 72");
    REQUIRE(key(queue.pop()) == key(sorted.front()));
    sorted.erase(sorted.begin());
  }
  CHECK(queue.is_empty() == sorted.empty());
  queue.clear();
  CHECK(queue.is_empty());
}

}  // namespace
}  // namespace regista::graph
