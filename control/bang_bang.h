// Time-optimal motion of a double integrator to rest: along one axis in closed form, in the plane by two axes that
// share the acceleration so that both arrive together.
#pragma once

#include "world_model/types/geometry.h"
#include "world_model/types/robot_limits.h"

namespace regista {

struct AxisLimits {
  double acceleration = 0.0;  ///< > 0, as all
  double braking = 0.0;
  double speed_max = 0.0;
};

/// Seconds the fastest motion takes from `velocity` to rest `distance` away (both signed).
double bang_bang_duration(double distance, double velocity, const AxisLimits& limits);

/// The velocity of that motion after dt_s >= 0.
double bang_bang_velocity(double distance, double velocity, const AxisLimits& limits, double dt_s);

/// The same in the plane: `way_m` to the goal, at rest there. Axes in four rotations fixed in the
/// field, on a straight drive also the way's own, are tried and the fastest taken; each axis gets the part cos α, sin α
/// of the limits, with α such that both take equally long. How much slower that is than the true optimum, `regista
/// bench motion` tells (README). The result is the velocity after dt_s. Only the axis with most of the way brakes
/// harder than it speeds up; where the velocity has another direction, motion_limits.h may cut that.
Vec2 bang_bang_velocity(const Vec2& way_m, const Vec2& velocity_mps, const RobotLimits& limits, double dt_s);

}  // namespace regista
