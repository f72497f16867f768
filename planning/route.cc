#include "planning/route.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace regista {
namespace {

/// The middle of what league teams drive with (SSL facts); a route is but a guess.
constexpr double kAcceleration_mps2 = 3.0;
constexpr double kBraking_mps2 = 4.0;

double length_of_legs(std::span<const Vec2> path) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) length_m += (path[i] - path[i - 1]).norm();
  return length_m;
}

}  // namespace

void follow(std::span<const Vec2> path, const Vec2& velocity_mps, double speed_max_mps, std::size_t steps, Route& out) {
  out.assign(1, path.front());
  double left_m = length_of_legs(path);
  std::size_t leg = 0;
  double on_leg_m = 0.0;
  const Vec2 first = path.size() > 1 ? Vec2(path[1] - path[0]) : Vec2(Vec2::Zero());
  double speed = first.isZero(0.0) ? 0.0 : std::max(0.0, velocity_mps.dot(first.normalized()));
  while (out.size() <= steps) {
    const double braked = std::sqrt(2.0 * kBraking_mps2 * left_m);
    const double next = std::min({speed + kAcceleration_mps2 * kRouteStep_s, speed_max_mps, braked});
    const double way_m = std::min(left_m, (speed + next) / 2.0 * kRouteStep_s);
    speed = next;
    left_m -= way_m;
    on_leg_m += way_m;
    Vec2 place = path[leg];
    while (leg + 1 < path.size()) {
      const Vec2 along = path[leg + 1] - path[leg];
      const double length_m = along.norm();
      if (on_leg_m < length_m) {
        place = path[leg] + (on_leg_m / length_m) * along;
        break;
      }
      on_leg_m -= length_m;
      place = path[++leg];
    }
    out.push_back(place);
  }
}

void drift(const Vec2& position_m, const Vec2& velocity_mps, double horizon_s, std::size_t steps, Route& out) {
  out.clear();
  for (std::size_t i = 0; i <= steps; ++i) {
    out.push_back(position_m + std::min(horizon_s, static_cast<double>(i) * kRouteStep_s) * velocity_mps);
  }
}

Vec2 way_to_nearest_approach(const Route& self, const Route& other) {
  double nearest2 = (other[0] - self[0]).squaredNorm();
  Vec2 way = Vec2::Zero();
  for (std::size_t i = 1; i < self.size(); ++i) {
    const Vec2 apart = other[i - 1] - self[i - 1];
    const Vec2 change = (other[i] - self[i]) - apart;
    const double change2 = change.squaredNorm();
    const double part = change2 > 0.0 ? std::clamp(-apart.dot(change) / change2, 0.0, 1.0) : 0.0;
    const double distance2 = (apart + part * change).squaredNorm();
    if (distance2 >= nearest2) continue;
    nearest2 = distance2;
    way = other[i - 1] + part * (other[i] - other[i - 1]) - other[0];
  }
  return way;
}

}  // namespace regista
