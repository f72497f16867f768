#include "control/safety/published_search.h"

#include <array>
#include <numbers>
#include <vector>

#include "control/motion_limits.h"
#include "control/safety/motion.h"
#include "control/safety/separation.h"

namespace regista {
namespace {

constexpr double kRange_m = 1.5;   ///< "within a certain range": the way to a stop from full speed and a body more
constexpr double kPeriod_s = 0.3;  ///< "a short period": a tenth of a second more than reaction and delay take
constexpr int kDirections = 8;     ///< of an obstacle's acceleration; "the more precise, the more samples"

Vec2 direction(int i, int count) { return rotated(Vec2::UnitX(), 2.0 * std::numbers::pi * i / count); }

/// All motions that the obstacles in range may choose.
std::vector<Motion> sampled_motions(std::span<const SafetyRobot> team, std::size_t self,
                                    std::span<const Opponent> opponents, const RobotLimits& limits) {
  std::vector<Motion> motions;
  const auto add = [&](const Vec2& position_m, const Vec2& velocity_mps) {
    if ((position_m - team[self].position_m).norm() > kRange_m) return;
    for (int i = 0; i < kDirections; ++i) {
      Motion motion(position_m, velocity_mps);
      motion.then(limits.acceleration_max_mps2 * direction(i, kDirections), kPeriod_s);
      motions.push_back(motion);
    }
  };
  for (std::size_t i = 0; i < team.size(); ++i) {
    if (i != self) add(team[i].position_m, team[i].velocity_mps);
  }
  for (const Opponent& opponent : opponents) add(opponent.position_m, opponent.velocity_mps);
  return motions;
}

}  // namespace

Vec2 published_choice(std::span<const SafetyRobot> team, std::size_t self, std::span<const Opponent> opponents,
                      const RobotLimits& limits, const SafetyParams& params, double period_s) {
  const SafetyRobot& robot = team[self];
  const std::vector<Motion> others = sampled_motions(team, self, opponents, limits);
  const double gap_m = 2.0 * limits.radius_m + params.team_margin_m;
  const auto hits = [&](const Vec2& velocity_mps) {
    Motion ours(robot.position_m, robot.velocity_mps);
    ours.then((velocity_mps - robot.velocity_mps) / period_s, period_s);
    ours.then(Vec2::Zero(), kPeriod_s);
    return std::count_if(others.begin(), others.end(),
                         [&](const Motion& other) { return !keep_apart(ours, other, {gap_m}, kPeriod_s); });
  };
  Vec2 best =
      limited_velocity(robot.velocity_mps, clamped_norm(robot.wanted_mps, robot.speed_max_mps), limits, period_s);
  auto fewest = hits(best);
  if (fewest == 0) return best;
  const double largest_mps = std::max(limits.acceleration_max_mps2, limits.braking_max_mps2) * period_s;
  const Vec2 wanted = best;
  for (const double magnitude : {1.0 / 3.0, 2.0 / 3.0, 1.0}) {
    for (int i = 0; i < params.directions; ++i) {
      const Vec2 compensated =
          wanted + 2.0 * magnitude * largest_mps * direction(i, static_cast<int>(params.directions));
      const Vec2 reachable =
          limited_velocity(robot.velocity_mps, clamped_norm(compensated, robot.speed_max_mps), limits, period_s);
      const auto count = hits(reachable);
      if (count >= fewest) continue;
      fewest = count;
      best = reachable;
    }
  }
  return best;
}

}  // namespace regista
