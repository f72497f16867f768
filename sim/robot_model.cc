#include "sim/robot_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace regista {
namespace {

// As wrap_angle, cheaper: one step never turns by more than half a turn.
double wrap_once(double angle_rad) {
  constexpr double pi = std::numbers::pi;
  if (angle_rad > pi) return angle_rad - 2.0 * pi;
  return angle_rad <= -pi ? angle_rad + 2.0 * pi : angle_rad;
}

}  // namespace

Vec2 limited_change(const Vec2& velocity_mps, const Vec2& change_mps, const RobotLimits& limits, double dt_s) {
  const double gain = limits.acceleration_max_mps2 * dt_s;
  const double loss = limits.braking_max_mps2 * dt_s;
  const double least = std::min(gain, loss);
  if (change_mps.squaredNorm() <= least * least) return change_mps;  // within every limit: the common case
  const double speed = velocity_mps.norm();
  if (speed == 0.0) return clamped_norm(change_mps, gain);
  const Vec2 ahead = velocity_mps / speed;
  const double along = change_mps.dot(ahead);
  if (along >= 0.0) return clamped_norm(change_mps, gain);
  // A step that brakes through zero ends by speeding up the other way, so there the smaller limit holds.
  const double loss_here = speed >= loss ? loss : std::max(speed, least);
  const Vec2 used(along / loss_here, cross(ahead, change_mps) / gain);
  const double excess_squared = used.squaredNorm();
  return excess_squared > 1.0 ? Vec2(change_mps / std::sqrt(excess_squared)) : change_mps;
}

void step(RobotBody& body, const BodyVelocity& commanded, const RobotLimits& limits, double velocity_lag_s,
          double dt_s) {
  const double followed = velocity_lag_s > 0.0 ? -std::expm1(-dt_s / velocity_lag_s) : 1.0;
  const Twist before = body.twist;

  const double turn_wanted =
      std::clamp(commanded.angular_radps, -limits.angular_speed_max_radps, limits.angular_speed_max_radps);
  const double turn_change_max = limits.angular_acceleration_max_radps2 * dt_s;
  body.twist.angular_radps +=
      std::clamp((turn_wanted - before.angular_radps) * followed, -turn_change_max, turn_change_max);
  body.pose.heading_rad =
      wrap_once(body.pose.heading_rad + (before.angular_radps + body.twist.angular_radps) / 2.0 * dt_s);

  // The heading at the end of the step: velocity and heading belong to the same moment.
  const Vec2 told = clamped_norm({commanded.forward_mps, commanded.left_mps}, limits.speed_max_mps);
  const Vec2 wanted = rotated(told, body.pose.heading_rad);
  const Vec2 change = (wanted - before.velocity_mps) * followed;
  body.twist.velocity_mps += limited_change(before.velocity_mps, change, limits, dt_s);
  body.pose.position_m += (before.velocity_mps + body.twist.velocity_mps) / 2.0 * dt_s;
}

void brake(RobotBody& body, const RobotLimits& limits, double dt_s) { step(body, {}, limits, 0.0, dt_s); }

}  // namespace regista
