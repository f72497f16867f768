#include "control/acceleration_estimate.h"

namespace regista {

void AccelerationEstimate::update(const WorldState& world, Team team, double dt_s, double filter_s,
                                  double largest_mps2) {
  std::map<RobotId, Estimate> next;
  for (const RobotState& robot : world.robots) {
    if (robot.id.team != team) continue;
    Estimate estimate{robot.twist.velocity_mps, Vec2::Zero()};
    if (const auto last = estimates_.find(robot.id); last != estimates_.end()) {
      const Vec2 raw = (robot.twist.velocity_mps - last->second.velocity_mps) / dt_s;
      const Vec2& smooth = last->second.acceleration_mps2;
      estimate.acceleration_mps2 = clamped_norm(smooth + dt_s / (filter_s + dt_s) * (raw - smooth), largest_mps2);
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
