#include "modules/bench/paper/dvg_groups.h"

#include <algorithm>
#include <functional>

namespace regista::bench {

std::vector<std::size_t> group_sizes(std::span<const Vec2> robots, double group_distance_m) {
  std::vector<std::size_t> sizes;
  std::vector<bool> taken(robots.size(), false);
  for (std::size_t first = 0; first < robots.size(); ++first) {
    if (taken[first]) continue;
    taken[first] = true;
    std::vector<std::size_t> group{first};
    for (std::size_t next = 0; next < group.size(); ++next) {
      for (std::size_t i = first + 1; i < robots.size(); ++i) {
        if (taken[i] || (robots[i] - robots[group[next]]).norm() >= group_distance_m) continue;
        taken[i] = true;
        group.push_back(i);
      }
    }
    sizes.push_back(group.size());
  }
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  return sizes;
}

}  // namespace regista::bench
