// From a path and a robot's state to the velocity it shall have next: along the leg it is on as fast as the corners and
// the end ahead permit (backward speed profile), across it back to the path, each as a time-optimal motion of its own.
#pragma once

#include <span>

#include "control/control_params.h"

namespace regista {

/// The velocity, field frame, for the next dt_s: `velocity_mps` is the present one. Comes to rest at the path's end,
/// zero within the settle distance. Works from anywhere, also beside or beyond the path. The path must have a point,
/// all numbers must be finite, speed_max >= 0. The result is no faster than limits.speed_max_mps, but only
/// motion_limits.h makes sure that it is reachable within dt_s.
Vec2 follow_path(std::span<const Vec2> path, const Vec2& position_m, const Vec2& velocity_mps,
                 const RobotLimits& limits, const FollowerParams& params, double dt_s);

}  // namespace regista
