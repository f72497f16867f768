#include "control/acceleration_estimate.h"

namespace regista {
namespace {

/// Who is seen to change its velocity by so much within so short a time was hit: ten times what a robot can do at 100
/// Hz. With the delays and noise of preset noisy no hit shows so abruptly, and half as much made no fewer fouls there.
/// Over longer times, or by one that was out of sight, it may be its own doing.
constexpr double kHit_mps = 0.4;
constexpr double kHitWithin_s = 0.02;
/// About what expected accelerations last (SafetyParams): who is back sooner accelerates less.
constexpr double kResumed_s = 0.3;

}  // namespace

void AccelerationEstimate::update(const WorldState& world, Team team, double dt_s, double filter_s, double largest_mps2,
                                  double resumes_mps2) {
  std::map<RobotId, Estimate> next;
  for (const RobotState& robot : world.robots) {
    if (robot.id.team != team) continue;
    const Vec2& velocity = robot.twist.velocity_mps;
    Estimate estimate{velocity, Vec2::Zero(), velocity, to_seconds(robot.age) <= kHitWithin_s};
    if (const auto last = estimates_.find(robot.id); last != estimates_.end()) {
      const Vec2 change = velocity - last->second.velocity_mps;
      const bool is_abrupt = dt_s <= kHitWithin_s && estimate.is_in_sight && last->second.is_in_sight;
      if (is_abrupt && change.norm() > kHit_mps) {
        estimate.unhit_mps = last->second.unhit_mps;
        estimate.acceleration_mps2 = clamped_norm((estimate.unhit_mps - velocity) / kResumed_s, resumes_mps2);
      } else {
        const Vec2& smooth = last->second.acceleration_mps2;
        estimate.acceleration_mps2 =
            clamped_norm(smooth + dt_s / (filter_s + dt_s) * (change / dt_s - smooth), largest_mps2);
      }
    }
    next.emplace_hint(next.end(), robot.id, estimate);
  }
  estimates_ = std::move(next);
}

Vec2 AccelerationEstimate::of(RobotId id) const {
  const auto found = estimates_.find(id);
  return found != estimates_.end() ? found->second.acceleration_mps2 : Vec2(Vec2::Zero());
}

}  // namespace regista
