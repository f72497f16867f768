#include "control/path_follower.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "control/corners.h"
#include "control/path_legs.h"
#include "control/speed_profile.h"

namespace regista {
namespace {

/// A velocity in the axes of a leg.
struct LegVelocity {
  double along = 0.0;   ///< in the leg's direction
  double across = 0.0;  ///< to its left
};

Vec2 left_of(const Vec2& direction) { return {-direction.y(), direction.x()}; }

/// The velocity over an offset, of either sign, that ends at rest there.
double approach_velocity(double offset_m, double braking, double settle_time_s, double dt_s) {
  return std::copysign(approach_speed(std::abs(offset_m), braking, settle_time_s, dt_s), offset_m);
}

/// Drops the legs whose end the robot is so near to that its turn into the next has to begin.
std::span<const Leg> begin_turns(std::span<const Leg> legs, const Vec2& position_m, double speed,
                                 const RobotLimits& limits, const FollowerParams& params) {
  while (legs.size() > 1) {
    const double turn_speed = std::min(speed, corner_speed(legs, limits, params));
    const double turn_m = turn_distance(turn_speed, legs.front().turn_rad, limits.acceleration_max_mps2);
    if (distance_to_end(legs.front(), position_m) > turn_m) break;
    legs = legs.subspan(1);
  }
  return legs;
}

/// The largest speed now, to_corner_m before the end of the first leg, from which every corner ahead and the end can be
/// met. A corner's speed holds from where its turn begins to where it ends; meanwhile braking has only what turning
/// leaves. What lies beyond the braking distance is not looked at.
double speed_along(std::span<const Leg> legs, double to_corner_m, const RobotLimits& limits,
                   const FollowerParams& params, double dt_s) {
  const double braking = params.braking_share * limits.braking_max_mps2;
  const double reach_m = limits.speed_max_mps * limits.speed_max_mps / (2.0 * braking);
  std::vector<double> speeds{limits.speed_max_mps};
  std::vector<double> lengths;      // a stretch with less braking counts as shorter
  double planned_m = 0.0;           // from the robot to where the speeds reach
  double distance_m = to_corner_m;  // from the robot to the end of the leg looked at
  for (std::size_t i = 0; i + 1 < legs.size() && planned_m <= reach_m; ++i) {
    const double speed = corner_speed(legs.subspan(i), limits, params);
    const double turn_m = turn_distance(speed, legs[i].turn_rad, limits.acceleration_max_mps2);
    const double begin_m = std::max(planned_m, distance_m - turn_m);
    const double end_m = std::max(begin_m, distance_m + turn_m);
    speeds.insert(speeds.end(), {speed, speed});
    lengths.insert(lengths.end(), {begin_m - planned_m, kAlongShare * (end_m - begin_m)});
    planned_m = end_m;
    distance_m += legs[i + 1].length_m;
  }
  // Rest at the end of the last leg looked at: the path's end, or a place further than braking takes.
  const double rest_m = std::max(0.0, distance_m - planned_m);
  speeds.back() = std::min(speeds.back(), approach_speed(rest_m, braking, params.settle_time_s, dt_s));
  profile_backwards(speeds, lengths, braking);
  return speeds.front();
}

/// On the way: as fast as what is ahead permits, and back to the leg.
LegVelocity along_leg(std::span<const Leg> legs, const Vec2& position_m, const RobotLimits& limits,
                      const FollowerParams& params, double dt_s) {
  const Leg& leg = legs.front();
  const double aside_m = (leg.from - position_m).dot(left_of(leg.direction));
  return {speed_along(legs, distance_to_end(leg, position_m), limits, params, dt_s),
          approach_velocity(aside_m, kAcrossShare * limits.acceleration_max_mps2, params.return_time_s, dt_s)};
}

/// On the last leg: to its end in both axes, from all sides.
LegVelocity to_end(const Vec2& way_m, const Vec2& direction, const RobotLimits& limits, const FollowerParams& params,
                   double dt_s) {
  const Vec2 way = way_m * (1.0 - params.settle_distance_m / way_m.norm());
  return {
      approach_velocity(way.dot(direction), params.braking_share * limits.braking_max_mps2, params.settle_time_s, dt_s),
      approach_velocity(way.dot(left_of(direction)), kAcrossShare * limits.acceleration_max_mps2, params.settle_time_s,
                        dt_s)};
}

/// What to ask for next to come to the wanted velocity. The part across goes first: were the whole change asked for at
/// once, speeding up on a new leg would starve the turn into it and carry the robot off the path.
Vec2 across_first(const Vec2& velocity_mps, const Vec2& direction, const LegVelocity& wanted, const RobotLimits& limits,
                  double dt_s) {
  const Vec2 left = left_of(direction);
  const double across = std::clamp(wanted.across, -limits.speed_max_mps, limits.speed_max_mps);
  const double along_cap = std::sqrt(limits.speed_max_mps * limits.speed_max_mps - across * across);
  const double along = std::clamp(wanted.along, -along_cap, along_cap);
  const double across_now = velocity_mps.dot(left);
  // The limits (motion_limits.h) in the direction of the change across: an ellipse with braking where it slows down.
  const double speed = velocity_mps.norm();
  const double slowing = across_now * (across - across_now) < 0.0 ? std::min(1.0, std::abs(across_now) / speed) : 0.0;
  const double across_max = dt_s / std::hypot(slowing / limits.braking_max_mps2,
                                              std::sqrt(1.0 - slowing * slowing) / limits.acceleration_max_mps2);
  const double share = std::clamp((across - across_now) / across_max, -kAcrossShare, kAcrossShare);
  const double along_max = limits.acceleration_max_mps2 * dt_s * std::sqrt(1.0 - share * share);
  const Vec2 next =
      std::min(along, velocity_mps.dot(direction) + along_max) * direction + (across_now + share * across_max) * left;
  return clamped_norm(next, limits.speed_max_mps);
}

}  // namespace

Vec2 follow_path(std::span<const Vec2> path, const Vec2& position_m, const Vec2& velocity_mps,
                 const RobotLimits& limits, const FollowerParams& params, double dt_s) {
  const std::vector<Leg> all_legs = legs_ahead(path, position_m);
  const std::span<const Leg> legs = begin_turns(all_legs, position_m, velocity_mps.norm(), limits, params);
  if (legs.size() > 1) {
    return across_first(velocity_mps, legs.front().direction, along_leg(legs, position_m, limits, params, dt_s), limits,
                        dt_s);
  }
  const Vec2 way_m = path.back() - position_m;
  if (way_m.norm() <= params.settle_distance_m) return Vec2::Zero();
  const Vec2 direction = legs.empty() ? Vec2(way_m.normalized()) : legs.front().direction;
  return across_first(velocity_mps, direction, to_end(way_m, direction, limits, params, dt_s), limits, dt_s);
}

}  // namespace regista
