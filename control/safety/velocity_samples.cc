#include "control/safety/velocity_samples.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "control/motion_limits.h"

namespace regista {
namespace {

/// Parts of the largest acceleration that are sampled.
constexpr std::array kMagnitudes{1.0, 2.0 / 3.0, 1.0 / 3.0};

}  // namespace

void sample_velocities(const SafetyRobot& robot, const RobotLimits& limits, std::int64_t directions, double period_s,
                       std::vector<VelocitySample>& out) {
  out.clear();
  const double largest_mps = std::max(limits.acceleration_max_mps2, limits.braking_max_mps2) * period_s;
  const auto add = [&](const Vec2& velocity_mps) {
    const Vec2 reachable =
        limited_velocity(robot.velocity_mps, clamped_norm(velocity_mps, robot.speed_max_mps), limits, period_s);
    out.emplace_back((reachable - robot.wanted_mps).squaredNorm(), reachable);
  };
  add(robot.wanted_mps);
  add(Vec2::Zero());
  add(robot.velocity_mps);
  // Directions are counted from the wanted one, so that turning the field turns the answer.
  const Vec2 change = robot.wanted_mps - robot.velocity_mps;
  const Vec2 ahead = change.isZero(0.0) ? Vec2(Vec2::UnitX()) : Vec2(change.normalized());
  for (std::int64_t i = 0; i < directions; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(directions);
    const Vec2 direction = rotated(ahead, angle);
    const Vec2 furthest =
        limited_velocity(robot.velocity_mps, robot.velocity_mps + largest_mps * direction, limits, period_s);
    for (const double magnitude : kMagnitudes) {
      add(robot.velocity_mps + magnitude * (furthest - robot.velocity_mps));
    }
  }
  // The wish as far as it can be granted comes first, even where another sample is nearer to it.
  std::stable_sort(out.begin() + 1, out.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
}

}  // namespace regista
