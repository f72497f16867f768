#include "control/path_follower.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "control/bang_bang.h"
#include "control/corners.h"
#include "control/path_legs.h"
#include "control/speed_profile.h"

namespace regista {
namespace {

Vec2 left_of(const Vec2& direction) { return {-direction.y(), direction.x()}; }

/// The point of the path that is steered for, and the number of legs before its own.
struct Pursuit {
  Vec2 point_m = Vec2::Zero();
  std::size_t leg = 0;
};

/// That far along the path from where the robot is beside it; the path's end where that is nearer.
Pursuit pursuit(std::span<const Leg> legs, const Vec2& position_m, double ahead_m) {
  double left_m = ahead_m + std::clamp((position_m - legs[0].from).dot(legs[0].direction), 0.0, legs[0].length_m);
  for (std::size_t i = 0;; ++i) {
    if (left_m <= legs[i].length_m || i + 1 == legs.size()) {
      return {legs[i].from + std::min(left_m, legs[i].length_m) * legs[i].direction, i};
    }
    left_m -= legs[i].length_m;
  }
}

/// The largest speed now from which every corner ahead and the end can be met. What lies beyond the braking distance is
/// not looked at.
double speed_along(std::span<const Leg> legs, const Vec2& position_m, const RobotLimits& limits,
                   const FollowerParams& params) {
  const double braking = params.braking_share * limits.braking_max_mps2;
  double speed = limits.speed_max_mps;
  double distance_m = std::max(0.0, distance_to_end(legs[0], position_m));
  for (std::size_t i = 0; 2.0 * braking * distance_m < speed * speed; ++i) {
    const bool ends = i + 1 == legs.size();
    speed =
        std::min(speed, speed_before(distance_m, ends ? 0.0 : corner_speed(legs.subspan(i), limits, params), braking));
    if (ends) break;
    distance_m += legs[i + 1].length_m;
  }
  return speed;
}

/// What to ask for next to drive in that direction. The part across goes first, within its share: were the whole
/// change asked for at once, speeding up would starve the turn.
Vec2 across_first(const Vec2& velocity_mps, const Vec2& direction, double speed, const RobotLimits& limits,
                  double across_share, double dt_s) {
  const Vec2 left = left_of(direction);
  const double across_now = velocity_mps.dot(left);
  // The limits (motion_limits.h) in the direction of the change across: an ellipse with braking where it slows down.
  const double speed_now = velocity_mps.norm();
  const double slowing = speed_now > 0.0 ? std::min(1.0, std::abs(across_now) / speed_now) : 0.0;
  const double across_max = dt_s / std::hypot(slowing / limits.braking_max_mps2,
                                              std::sqrt(1.0 - slowing * slowing) / limits.acceleration_max_mps2);
  const double along_now = velocity_mps.dot(direction);
  const bool speeds_up = speed - along_now > limits.acceleration_max_mps2 * dt_s;
  const double share_max = speeds_up ? across_share : kAcrossShare;
  const double share = std::clamp(-across_now / across_max, -share_max, share_max);
  const double along_max = limits.acceleration_max_mps2 * dt_s * std::sqrt(1.0 - share * share);
  const Vec2 next = std::min(speed, along_now + along_max) * direction + (across_now + share * across_max) * left;
  return clamped_norm(next, limits.speed_max_mps);
}

/// On the last leg: straight to its end as fast as possible, and there, where noise would make that tremble, slowly.
Vec2 to_end(const Vec2& way_m, const Vec2& velocity_mps, const RobotLimits& limits, const FollowerParams& params,
            double dt_s) {
  const double distance_m = way_m.norm();
  if (distance_m <= params.settle_distance_m) return Vec2::Zero();
  RobotLimits planned = limits;
  planned.braking_max_mps2 *= params.braking_share;
  const double settling_m = 2.0 * planned.braking_max_mps2 * params.settle_time_s * params.settle_time_s;
  if (distance_m > settling_m) {
    // An axis above its share of the limit slows down while the other speeds up: together they may exceed the limit.
    return clamped_norm(bang_bang_velocity(way_m, velocity_mps, planned, dt_s), limits.speed_max_mps);
  }
  return approach_speed(distance_m - params.settle_distance_m, planned.braking_max_mps2, params.settle_time_s, dt_s) /
         distance_m * way_m;
}

}  // namespace

Vec2 follow_path(std::span<const Vec2> path, const Vec2& position_m, const Vec2& velocity_mps,
                 const RobotLimits& limits, const FollowerParams& params, double dt_s) {
  if (!(limits.speed_max_mps > 0.0)) return Vec2::Zero();
  const std::vector<Leg> legs = legs_ahead(path, position_m);
  const double ahead_m = params.pursuit_distance_m + params.pursuit_time_s * velocity_mps.norm();
  const Pursuit aim = legs.empty() ? Pursuit{path.back()} : pursuit(legs, position_m, ahead_m);
  if (aim.leg + 1 >= legs.size()) return to_end(path.back() - position_m, velocity_mps, limits, params, dt_s);
  const Vec2 way_m = aim.point_m - position_m;
  if (way_m.isZero(0.0)) return velocity_mps;
  return across_first(velocity_mps, way_m.normalized(), speed_along(legs, position_m, limits, params), limits,
                      params.across_share, dt_s);
}

}  // namespace regista
