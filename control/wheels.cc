#include "control/wheels.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

namespace regista {
namespace {

/// Weaker than this against the strongest, a motion is none that the wheels can drive; any sane robot has 10⁻³ and
/// more.
constexpr double kLeastMotion = 1e-9;

std::array<double, 4> bearings_of(const WheelGeometry& geometry) {
  if (geometry.bearings_rad.empty()) {
    return {geometry.front_bearing_rad, geometry.rear_bearing_rad, -geometry.rear_bearing_rad,
            -geometry.front_bearing_rad};
  }
  std::array<double, 4> bearings{};
  const char* at = geometry.bearings_rad.data();
  const char* const end = at + geometry.bearings_rad.size();
  bool is_good = true;
  for (double& bearing : bearings) {
    const auto [next, error] = std::from_chars(at, end, bearing);
    // A comma after each but the last.
    const bool is_closed = &bearing == &bearings.back() ? next == end : next != end && *next == ',';
    is_good = is_good && error == std::errc{} && is_closed && std::abs(bearing) <= 2.0 * std::numbers::pi;
    at = next == end ? end : next + 1;
  }
  if (is_good) return bearings;
  throw std::invalid_argument("OmniWheels: bearings_rad is '" + geometry.bearings_rad +
                              "', must be four numbers with commas between, in radians from forward to the left");
}

}  // namespace

OmniWheels::OmniWheels(const WheelGeometry& geometry) : speed_max_radps_(geometry.wheel_speed_max_radps) {
  const std::array<double, 4> bearings = bearings_of(geometry);
  for (int i = 0; i < 4; ++i) {
    // A hub at bearing β moves with v + ω × r; the wheel drives along the tangent (−sin β, cos β), its rollers let the
    // rest slip.
    const double bearing = bearings[static_cast<std::size_t>(i)];
    to_wheels_.row(i) << -std::sin(bearing), std::cos(bearing), geometry.hub_radius_m;
  }
  to_wheels_ /= geometry.wheel_radius_m;
  const Eigen::Matrix3d normal = to_wheels_.transpose() * to_wheels_;
  // Ascending: how strongly the wheels answer to the body's three independent motions.
  const Eigen::Vector3d motions = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(normal).eigenvalues();
  if (!(geometry.wheel_radius_m > 0.0 && geometry.hub_radius_m > 0.0 && speed_max_radps_ > 0.0 &&
        motions[0] > kLeastMotion * motions[2])) {
    throw std::invalid_argument(
        "OmniWheels: bearings " + std::to_string(bearings[0]) + ", " + std::to_string(bearings[1]) + ", " +
        std::to_string(bearings[2]) + " and " + std::to_string(bearings[3]) + " rad, hub radius " +
        std::to_string(geometry.hub_radius_m) + " m, wheel radius " + std::to_string(geometry.wheel_radius_m) +
        " m, limit " + std::to_string(speed_max_radps_) + " rad/s do not make a robot that can move");
  }
  to_body_ = normal.inverse() * to_wheels_.transpose();
}

WheelSpeeds OmniWheels::speeds(const BodyVelocity& body) const {
  const Eigen::Vector4d wheels = to_wheels_ * Eigen::Vector3d(body.forward_mps, body.left_mps, body.angular_radps);
  return {wheels[0], wheels[1], wheels[2], wheels[3]};
}

BodyVelocity OmniWheels::velocity(const WheelSpeeds& wheels) const {
  const Eigen::Vector3d body = to_body_ * Eigen::Vector4d(wheels[0], wheels[1], wheels[2], wheels[3]);
  return {body[0], body[1], body[2]};
}

double OmniWheels::scale_to_limit(const WheelSpeeds& wheels) const {
  double fastest = 0.0;
  for (const double speed : wheels) fastest = std::max(fastest, std::abs(speed));
  return fastest > speed_max_radps_ ? speed_max_radps_ / fastest : 1.0;
}

}  // namespace regista
