#include "control/corners.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace regista {
namespace {

/// So many vertices are looked at as one bend; a full turn drawn with them has corners of 11°.
constexpr std::size_t kBendVertices = 32;

}  // namespace

double bend_speed(double turn_rad, double bend_length_m, double acceleration, double tolerance_m) {
  const double sine = std::sin(turn_rad / 2.0);
  if (sine <= 0.0) return std::numeric_limits<double>::infinity();
  const double radius_m = std::max(2.0 * tolerance_m / (sine * sine), bend_length_m / turn_rad);
  return std::sqrt(acceleration * radius_m);
}

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

}  // namespace regista
