// Where a robot will be while it follows its path: what team-mates know of each other, and more than its velocity tells.
#pragma once

#include <span>
#include <vector>

#include "world_model/types/geometry.h"

namespace regista {

/// Between two places of a route, seconds: at most 0.3 m apart, straight in between.
inline constexpr double kRouteStep_s = 0.1;

/// Places at 0, 1, 2 … steps from now on.
using Route = std::vector<Vec2>;

/// Along the path (at least one point, from where the robot is) with the speed it has along it, speeding up to
/// speed_max_mps and braking to its end as robots of the league do; `steps` >= 0 of them.
void follow(std::span<const Vec2> path, const Vec2& velocity_mps, double speed_max_mps, std::size_t steps, Route& out);

/// Straight on with that velocity for horizon_s, then no farther.
void drift(const Vec2& position_m, const Vec2& velocity_mps, double horizon_s, std::size_t steps, Route& out);

/// How far the second moves until both are nearest; routes of the same length.
Vec2 way_to_nearest_approach(const Route& self, const Route& other);

}  // namespace regista
