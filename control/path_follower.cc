#include "control/path_follower.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "control/speed_profile.h"

namespace regista {
namespace {

/// Shorter legs have no direction worth the name; leaving them out moves the path by less than vision can see.
constexpr double kLegMin_m = 1e-3;
/// Bends are looked at over so many vertices: an arc drawn as a polyline bends at each a little.
constexpr std::size_t kBendVertices = 32;
/// Of the possible change of velocity, how much may go into motion across the path, and what that leaves along it:
/// √(1 − 0.9²).
constexpr double kAcrossShare = 0.9;
constexpr double kAlongShare = 0.436;

struct Leg {
  Vec2 from;
  Vec2 direction;       ///< unit vector
  double length_m;
  double turn_rad = 0;  ///< from this leg into the next, positive to the left; 0 for the last
};

/// The legs from the robot's on. Empty where the path is but a point.
std::vector<Leg> legs_ahead(std::span<const Vec2> path, const Vec2& position_m) {
  std::vector<Leg> legs;
  const std::size_t first = nearest_leg(path, position_m);
  legs.reserve(path.size() - first);
  Vec2 from = path[first];
  for (std::size_t i = first + 1; i < path.size(); ++i) {
    const Vec2 way = path[i] - from;
    const double length_m = way.norm();
    if (length_m <= kLegMin_m) continue;
    legs.push_back({from, way / length_m, length_m});
    from = path[i];
  }
  for (std::size_t i = 0; i + 1 < legs.size(); ++i) {
    legs[i].turn_rad = std::atan2(cross(legs[i].direction, legs[i + 1].direction),
                                  legs[i].direction.dot(legs[i + 1].direction));
  }
  return legs;
}

/// The speed for the corner at the end of the first of these legs, seen together with the bends soon after it.
double corner_speed(std::span<const Leg> legs, const RobotLimits& limits, const FollowerParams& params) {
  double speed = limits.speed_max_mps;
  double turn = 0.0;
  double bend_length_m = 0.0;
  for (std::size_t i = 0; i + 1 < legs.size() && i < kBendVertices; ++i) {
    if (i > 0) bend_length_m += legs[i].length_m;
    turn += legs[i].turn_rad;
    speed = std::min(speed, bend_speed(std::min(std::abs(turn), std::numbers::pi), bend_length_m,
                                       kAcrossShare * limits.acceleration_max_mps2, params.corner_tolerance_m));
  }
  return std::min(std::max(speed, params.corner_speed_min_mps), limits.speed_max_mps);
}

/// The largest speed now, to_corner_m before the end of the first leg, from which every corner ahead and the end can be
/// met. A corner's speed holds from where its turn begins to where it ends; meanwhile braking has only what turning
/// leaves. Corners beyond the braking distance are not looked at.
double speed_along(std::span<const Leg> legs, double to_corner_m, const RobotLimits& limits,
                   const FollowerParams& params, double dt_s) {
  const double braking = params.braking_share * limits.braking_max_mps2;
  const double reach_m = limits.speed_max_mps * limits.speed_max_mps / (2.0 * braking);
  std::vector<double> speeds{limits.speed_max_mps};
  std::vector<double> lengths;  // a stretch with less braking counts as shorter
  double planned_m = 0.0;       // from the robot to where speeds are known
  double distance_m = to_corner_m;
  for (std::size_t i = 0; i + 1 < legs.size(); distance_m += legs[++i].length_m) {
    if (planned_m > reach_m) continue;
    const double speed = corner_speed(legs.subspan(i), limits, params);
    const double turn_m = turn_distance(speed, legs[i].turn_rad, limits.acceleration_max_mps2);
    const double begin_m = std::max(planned_m, distance_m - turn_m);
    const double end_m = std::max(begin_m, distance_m + turn_m);
    speeds.insert(speeds.end(), {speed, speed});
    lengths.insert(lengths.end(), {begin_m - planned_m, kAlongShare * (end_m - begin_m)});
    planned_m = end_m;
  }
  const double rest_m = std::max(0.0, distance_m - planned_m);
  speeds.back() = std::min(speeds.back(), approach_speed(rest_m, braking, params.settle_time_s, dt_s));
  profile_backwards(speeds, lengths, braking);
  return speeds.front();
}

/// The change of velocity, at most dt_s worth of the limits, towards `along` on the leg's direction and `across` to its
/// left. The part across goes first: were the whole change asked for at once, speeding up on a new leg would starve the
/// turn into it and carry the robot off the path.
Vec2 next_velocity(const Vec2& velocity_mps, const Vec2& direction, double along, double across,
                   const RobotLimits& limits, double dt_s) {
  const Vec2 left(-direction.y(), direction.x());
  const double along_now = velocity_mps.dot(direction);
  const double across_now = velocity_mps.dot(left);
  const double speed = velocity_mps.norm();
  // The limits (motion_limits.h) in the direction of the change across: braking where it slows the robot down.
  const double slowing = speed > 0.0 && across_now * (across - across_now) < 0.0 ? std::abs(across_now) / speed : 0.0;
  const double across_max = dt_s / std::hypot(slowing / limits.braking_max_mps2,
                                              std::sqrt(1.0 - std::min(1.0, slowing * slowing)) /
                                                  limits.acceleration_max_mps2);
  const double share = std::clamp((across - across_now) / across_max, -kAcrossShare, kAcrossShare);
  const double along_max = limits.acceleration_max_mps2 * dt_s * std::sqrt(1.0 - share * share);
  return std::min(along, along_now + along_max) * direction + (across_now + share * across_max) * left;
}

/// Drops the legs whose end the robot is so near to that its turn into the next has to begin.
std::span<const Leg> begin_turns(std::span<const Leg> legs, const Vec2& position_m, double speed,
                                 const RobotLimits& limits, const FollowerParams& params) {
  while (legs.size() > 1) {
    const Leg& leg = legs.front();
    const double to_corner_m = leg.length_m - (position_m - leg.from).dot(leg.direction);
    const double turn_speed = std::min(speed, corner_speed(legs, limits, params));
    if (to_corner_m > turn_distance(turn_speed, leg.turn_rad, limits.acceleration_max_mps2)) break;
    legs = legs.subspan(1);
  }
  return legs;
}

}  // namespace

std::size_t nearest_leg(std::span<const Vec2> path, const Vec2& position_m) {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double squared = (position_m - nearest_on_segment(position_m, path[i], path[i + 1])).squaredNorm();
    if (squared > least) continue;
    least = squared;
    nearest = i;
  }
  return nearest;
}

double bend_speed(double turn_rad, double bend_length_m, double acceleration, double tolerance_m) {
  const double sine = std::sin(turn_rad / 2.0);
  if (sine <= 0.0) return std::numeric_limits<double>::infinity();
  const double radius_m = std::max(2.0 * tolerance_m / (sine * sine), bend_length_m / turn_rad);
  return std::sqrt(acceleration * radius_m);
}

double turn_distance(double speed_mps, double turn_rad, double acceleration) {
  return speed_mps * speed_mps * std::sin(std::abs(turn_rad) / 2.0) / acceleration;
}

Vec2 follow_path(std::span<const Vec2> path, const Vec2& position_m, const Vec2& velocity_mps,
                 const RobotLimits& limits, const FollowerParams& params, double dt_s) {
  const double braking = params.braking_share * limits.braking_max_mps2;
  const std::vector<Leg> all = legs_ahead(path, position_m);
  const std::span<const Leg> legs = begin_turns(all, position_m, velocity_mps.norm(), limits, params);
  if (legs.size() <= 1) { // on the last leg
    const Vec2 way = path.back() - position_m;
    const double distance_m = way.norm();
    if (distance_m <= params.settle_distance_m) return Vec2::Zero();
    const Vec2 direction = legs.empty() ? Vec2(way / distance_m) : legs.front().direction;
    const Vec2 left(-direction.y(), direction.x());
    const double shrink = 1.0 - params.settle_distance_m / distance_m;
    const double along = way.dot(direction)*shrink, across = way.dot(left)*shrink;
    const double va = std::copysign(approach_speed(std::abs(across), kAcrossShare*limits.acceleration_max_mps2, params.settle_time_s, dt_s), across);
    const double vl = std::copysign(approach_speed(std::abs(along), braking, params.settle_time_s, dt_s), along);
    const double vac = std::clamp(va, -limits.speed_max_mps, limits.speed_max_mps);
    const double cap = std::sqrt(limits.speed_max_mps*limits.speed_max_mps - vac*vac);
    return next_velocity(velocity_mps, direction, std::clamp(vl, -cap, cap), vac, limits, dt_s);
  }
  const Leg& leg = legs.front();
  const Vec2 left(-leg.direction.y(), leg.direction.x());
  const double to_corner_m = leg.length_m - (position_m - leg.from).dot(leg.direction);
  const double across = (leg.from - position_m).dot(left);
  const double va = std::copysign(approach_speed(std::abs(across), kAcrossShare*limits.acceleration_max_mps2, params.return_time_s, dt_s), across);
  const double vac = std::clamp(va, -limits.speed_max_mps, limits.speed_max_mps);
  const double cap = std::sqrt(limits.speed_max_mps*limits.speed_max_mps - vac*vac);
  const double vl = std::min(cap, speed_along(legs, to_corner_m, limits, params, dt_s));
  return next_velocity(velocity_mps, leg.direction, vl, vac, limits, dt_s);
}

}  // namespace regista
