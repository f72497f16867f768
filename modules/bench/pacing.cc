#include "modules/bench/pacing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace regista::bench {

std::vector<std::size_t> strides(const std::vector<double>& query_s, std::size_t queries, double available_s) {
  std::vector<std::size_t> fastest_first(query_s.size());
  std::iota(fastest_first.begin(), fastest_first.end(), std::size_t{0});
  std::sort(fastest_first.begin(), fastest_first.end(),
            [&](std::size_t a, std::size_t b) { return query_s[a] < query_s[b]; });
  std::vector<std::size_t> every(query_s.size(), 1);
  std::size_t waiting = query_s.size();
  for (const std::size_t planner : fastest_first) {
    const double share_s = available_s / static_cast<double>(waiting--);
    const double needed_s = query_s[planner] * static_cast<double>(queries);
    if (needed_s > share_s) {
      const double least = std::ceil(needed_s / share_s);
      every[planner] = static_cast<std::size_t>(std::min(least, static_cast<double>(queries)));
    }
    available_s -= needed_s / static_cast<double>(every[planner]);
  }
  return every;
}

}  // namespace regista::bench
