#include "sim/ball_model.h"

#include <algorithm>
#include <cmath>

namespace regista {
namespace {

struct Run {
  double speed_mps = 0.0;
  double distance_m = 0.0;
  double time_left_s = 0.0;
};

// Uniform slowing down to floor_mps or to the end of the time left.
void slow_down(Run& run, double floor_mps, double deceleration_mps2) {
  if (run.speed_mps <= floor_mps) return;
  const double to_floor_s = (run.speed_mps - floor_mps) / deceleration_mps2;
  const double time_s = std::min(to_floor_s, run.time_left_s);
  run.distance_m += time_s * (run.speed_mps - deceleration_mps2 * time_s / 2.0);
  run.speed_mps = time_s == to_floor_s ? floor_mps : run.speed_mps - deceleration_mps2 * time_s;
  run.time_left_s -= time_s;
}

}  // namespace

void kick(BallBody& ball, const Vec2& velocity_mps, const BallParams& params) {
  ball.velocity_mps = clamped_norm(velocity_mps, params.speed_max_mps);
  ball.rolls_below_mps = params.roll_ratio * ball.velocity_mps.norm();
}

void step(BallBody& ball, const BallParams& params, double dt_s) {
  const double speed = ball.velocity_mps.norm();
  if (speed == 0.0) return;
  const Vec2 ahead = ball.velocity_mps / speed;
  Run run{speed, 0.0, dt_s};
  slow_down(run, ball.rolls_below_mps, params.slide_deceleration_mps2);
  slow_down(run, 0.0, params.roll_deceleration_mps2);
  ball.position_m += run.distance_m * ahead;
  ball.velocity_mps = run.speed_mps * ahead;
}

void push(BallBody& ball, const RobotBody& robot, double robot_radius_m, const BallParams& params) {
  const double touch = robot_radius_m + params.radius_m;
  const Vec2 off = ball.position_m - robot.pose.position_m;
  const double distance_squared = off.squaredNorm();
  if (distance_squared >= touch * touch) return;
  const double distance = std::sqrt(distance_squared);
  const Vec2 normal = distance > 0.0 ? Vec2(off / distance) : rotated({1.0, 0.0}, robot.pose.heading_rad);
  ball.position_m = robot.pose.position_m + touch * normal;
  const double closing = (robot.twist.velocity_mps - ball.velocity_mps).dot(normal);
  if (closing <= 0.0) return;
  ball.velocity_mps += closing * normal;
  ball.rolls_below_mps = std::max(ball.rolls_below_mps, ball.velocity_mps.norm());
}

bool can_kick(const BallBody& ball, const RobotBody& robot, double robot_radius_m, const BallParams& params) {
  const Vec2 off = ball.position_m - robot.pose.position_m;
  const double reach = robot_radius_m + params.radius_m + kKickReach_m;
  if (off.squaredNorm() > reach * reach) return false;
  const Vec2 seen = rotated(off, -robot.pose.heading_rad);
  return std::abs(std::atan2(seen.y(), seen.x())) <= kKickHalfAngle_rad;
}

}  // namespace regista
