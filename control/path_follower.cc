#include "control/path_follower.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "control/speed_profile.h"

namespace regista {
namespace {

/// Legs shorter than this have no direction worth the name: planners' rounding.
constexpr double kLegMin_m = 1e-6;
/// Bends are looked at over so many vertices: an arc drawn as a polyline bends at each a little.
constexpr std::size_t kBendVertices = 8;
/// Of the possible change of velocity, how much may go into turning; it leaves √(1 − 0.9²) = 0.44 for speeding up.
constexpr double kAcrossShare = 0.9;

/// What lies ahead: points[0] is the nearest point of the path, the rest its vertices to come, no leg without length.
struct Ahead {
  std::vector<Vec2> points;
  std::vector<double> lengths;  ///< of the legs between them
};

Ahead path_ahead(std::span<const Vec2> path, const PathPosition& at) {
  Ahead ahead{{at.point}, {}};
  ahead.points.reserve(path.size() - at.leg);
  ahead.lengths.reserve(path.size() - at.leg);
  for (std::size_t i = at.leg + 1; i < path.size(); ++i) {
    const double length = (path[i] - ahead.points.back()).norm();
    if (length <= kLegMin_m) continue;
    ahead.points.push_back(path[i]);
    ahead.lengths.push_back(length);
  }
  return ahead;
}

/// A point ahead on the path, and how far the path still goes from there.
struct Pursuit {
  Vec2 point;
  double rest_m;
};

/// At distance_m along the path, its end at most.
Pursuit pursuit_at(const Ahead& ahead, double distance_m) {
  const double length_m = std::accumulate(ahead.lengths.begin(), ahead.lengths.end(), 0.0);
  double on_leg_m = distance_m;
  for (std::size_t i = 0; i < ahead.lengths.size(); ++i) {
    if (on_leg_m < ahead.lengths[i]) {
      const Vec2 leg = ahead.points[i + 1] - ahead.points[i];
      return {ahead.points[i] + leg * (on_leg_m / ahead.lengths[i]), length_m - distance_m};
    }
    on_leg_m -= ahead.lengths[i];
  }
  return {ahead.points.back(), 0.0};
}

/// The largest speed now from which every corner ahead can be driven; corners further than the braking distance are not
/// looked at.
double speed_for_corners(const Ahead& ahead, const RobotLimits& limits, const FollowerParams& params, double braking) {
  const double reach_m = limits.speed_max_mps * limits.speed_max_mps / (2.0 * braking);
  std::vector<double> speeds{limits.speed_max_mps};
  double distance_m = 0.0;
  for (std::size_t i = 1; i + 1 < ahead.points.size(); ++i) {
    distance_m += ahead.lengths[i - 1];
    if (distance_m > reach_m) break;
    double speed = limits.speed_max_mps;
    double turn = 0.0;
    double bend_length_m = 0.0;
    for (std::size_t j = i; j + 1 < ahead.points.size() && j < i + kBendVertices; ++j) {
      const Vec2 in = ahead.points[j] - ahead.points[j - 1];
      const Vec2 out = ahead.points[j + 1] - ahead.points[j];
      turn += std::atan2(cross(in, out), in.dot(out));
      speed = std::min(speed, bend_speed(std::min(std::abs(turn), std::numbers::pi), bend_length_m,
                                         limits.acceleration_max_mps2, params.corner_tolerance_m));
      bend_length_m += ahead.lengths[j];
    }
    speeds.push_back(std::min(std::max(speed, params.corner_speed_min_mps), limits.speed_max_mps));
  }
  profile_backwards(speeds, std::span(ahead.lengths).first(speeds.size() - 1), braking);
  return speeds.front();
}

/// The velocity to want next when the robot shall come to move at `speed` along the unit vector `direction`. What it
/// moves across is taken away first: were the whole change asked for at once, speeding up on a new leg would starve the
/// turn into it and carry the robot off the path.
Vec2 turned_first(const Vec2& velocity_mps, const Vec2& direction, double speed, const RobotLimits& limits,
                  double dt_s) {
  const double along = velocity_mps.dot(direction);
  const Vec2 across = velocity_mps - along * direction;
  const double across_speed = across.norm();
  if (across_speed == 0.0) return speed * direction;
  // The limits' half ellipse (motion_limits.h) in the direction that slows the motion across.
  const double slowing = across_speed / velocity_mps.norm();
  const double across_max =
      dt_s / std::hypot(slowing / limits.braking_max_mps2,
                        std::sqrt(std::max(0.0, 1.0 - slowing * slowing)) / limits.acceleration_max_mps2);
  const double change = std::min(across_speed, kAcrossShare * across_max);
  const double left = std::sqrt(1.0 - change * change / (across_max * across_max));
  const double speed_next = std::min(speed, along + left * limits.acceleration_max_mps2 * dt_s);
  return speed_next * direction + across * (1.0 - change / across_speed);
}

}  // namespace

PathPosition locate(std::span<const Vec2> path, const Vec2& position_m) {
  PathPosition best{0, path.front(), (position_m - path.front()).norm()};
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec2 point = nearest_on_segment(position_m, path[i], path[i + 1]);
    const double distance_m = (position_m - point).norm();
    if (distance_m <= best.distance_m) best = {i, point, distance_m};
  }
  return best;
}

double bend_speed(double turn_rad, double bend_length_m, double acceleration, double tolerance_m) {
  const double cosine = std::cos(turn_rad / 2.0);
  if (cosine >= 1.0) return std::numeric_limits<double>::infinity();
  const double radius_m = tolerance_m * cosine / (1.0 - cosine) + bend_length_m / turn_rad;
  return std::sqrt(acceleration * radius_m);
}

Vec2 follow_path(std::span<const Vec2> path, const Vec2& position_m, const Vec2& velocity_mps,
                 const RobotLimits& limits, const FollowerParams& params, double dt_s) {
  const Ahead ahead = path_ahead(path, locate(path, position_m));
  const Pursuit pursuit = pursuit_at(ahead, params.pursuit_min_m + params.pursuit_time_s * velocity_mps.norm());
  const Vec2 way = pursuit.point - position_m;
  const double way_m = way.norm();
  const double remaining_m = way_m + pursuit.rest_m - params.settle_distance_m;
  if (remaining_m <= 0.0 || way_m == 0.0) return Vec2::Zero();
  const double braking = params.braking_share * limits.braking_max_mps2;
  const double speed = std::min(speed_for_corners(ahead, limits, params, braking),
                                approach_speed(remaining_m, braking, params.settle_time_s, dt_s));
  return turned_first(velocity_mps, way / way_m, speed, limits, dt_s);
}

}  // namespace regista
