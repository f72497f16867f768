#include "control/motion_limits.h"

#include <algorithm>
#include <cmath>

namespace regista {

Vec2 limited_velocity(const Vec2& present_mps, const Vec2& wanted_mps, const RobotLimits& limits, double dt_s) {
  const Vec2 change = wanted_mps - present_mps;
  const double speed = present_mps.norm();
  const double along = speed > 0.0 ? change.dot(present_mps) / speed : 0.0;
  // Half disc and half ellipse are one formula: the half axis along is the acceleration's or the braking's. A change
  // from rest has no direction that counts as along.
  const double along_max = (along < 0.0 ? limits.braking_max_mps2 : limits.acceleration_max_mps2) * dt_s;
  const double across_max = limits.acceleration_max_mps2 * dt_s;
  const double across_squared = std::max(0.0, change.squaredNorm() - along * along);
  const double used = std::sqrt(along * along / (along_max * along_max) + across_squared / (across_max * across_max));
  const Vec2 next = used > 1.0 ? Vec2(present_mps + change / used) : wanted_mps;
  // Braking beyond standstill speeds up the other way, and that only the acceleration may do.
  return clamped_norm(next, speed + limits.acceleration_max_mps2 * dt_s);
}

double limited_rate(double present_radps, double wanted_radps, const RobotLimits& limits, double dt_s) {
  const double change_max = limits.angular_acceleration_max_radps2 * dt_s;
  return std::clamp(wanted_radps, present_radps - change_max, present_radps + change_max);
}

}  // namespace regista
