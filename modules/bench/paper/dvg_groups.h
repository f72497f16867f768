// Groups of robots as table 3 of Costa & Tonidandel counts them.
#pragma once

#include <span>
#include <vector>

#include "world_model/types/geometry.h"

namespace regista::bench {

/// How many robots each group has: two robots nearer than that are in one group, also by way of others. A robot alone
/// is a group of one. Largest first.
std::vector<std::size_t> group_sizes(std::span<const Vec2> robots, double group_distance_m);

}  // namespace regista::bench
