#include "control/present_opponents.h"

#include <algorithm>

namespace regista {

double planning_delay_s(const WorldState& world, double drive_lag_s) {
  return std::max(0.0, to_seconds(world.valid_at - world.captured)) + drive_lag_s;
}

Opponent accelerated(const Vec2& coasting_m, const Vec2& velocity_mps, const Vec2& acceleration_mps2, double delay_s) {
  const double against = -acceleration_mps2.dot(velocity_mps);
  const double lasts_s = against > 0.0 ? std::min(delay_s, velocity_mps.squaredNorm() / against) : delay_s;
  return {coasting_m + lasts_s * (delay_s - lasts_s / 2.0) * acceleration_mps2,
          velocity_mps + lasts_s * acceleration_mps2, acceleration_mps2};
}

std::span<const Opponent> PresentOpponents::update(const WorldState& world, Team team, const ControlParams& params,
                                                   double dt_s) {
  accelerations_.update(world, team, dt_s, params.acceleration_filter_s,
                        std::max(params.limits.acceleration_max_mps2, params.limits.braking_max_mps2));
  // A change of mind is to be expected by then.
  const double delay_s = std::min(planning_delay_s(world, params.drive_lag_s), params.safety.acceleration_lasts_s);
  opponents_.clear();
  for (const RobotState& robot : world.robots) {
    if (robot.id.team != team) continue;
    // Ours are where their lag will have carried them; theirs are looked at as of the same moment.
    const Vec2 coasting_m = robot.pose.position_m + params.drive_lag_s * robot.twist.velocity_mps;
    opponents_.push_back(accelerated(coasting_m, robot.twist.velocity_mps, accelerations_.of(robot.id), delay_s));
  }
  return opponents_;
}

}  // namespace regista
