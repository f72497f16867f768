#include "control/present_opponents.h"

#include <algorithm>

namespace regista {

namespace {

/// What an estimated acceleration is carried on for at most: later it is a guess. With the delays of preset realistic,
/// 105 ms, two teams like ours touched four times as often.
constexpr double kLongestChange_s = 0.06;

}  // namespace

double planning_delay_s(const WorldState& world, double drive_lag_s) {
  return std::min(std::max(0.0, to_seconds(world.valid_at - world.captured)) + drive_lag_s, kLongestDelay_s);
}

Opponent accelerated(const Vec2& coasted_to_m, const Vec2& velocity_mps, const Vec2& acceleration_mps2, double delay_s,
                     double lasts_s) {
  const double against = -acceleration_mps2.dot(velocity_mps);
  const double stops_s = against > 0.0 ? velocity_mps.squaredNorm() / against : delay_s;
  if (stops_s < lasts_s) {
    const Vec2 coasted_from_m = coasted_to_m - delay_s * velocity_mps;
    return {.position_m = coasted_from_m + stops_s / 2.0 * velocity_mps};
  }
  return {.position_m = coasted_to_m + lasts_s * (delay_s - lasts_s / 2.0) * acceleration_mps2,
          .velocity_mps = velocity_mps + lasts_s * acceleration_mps2,
          .acceleration_mps2 = acceleration_mps2};
}

std::span<const Opponent> PresentOpponents::update(const WorldState& world, Team theirs, const ControlParams& params,
                                                   double dt_s) {
  const double delay_s = planning_delay_s(world, params.drive_lag_s);
  accelerations_.update(world, theirs, dt_s, params.acceleration_filter_s,
                        std::max(params.limits.acceleration_max_mps2, params.limits.braking_max_mps2));
  top_speed_.update(world, theirs, accelerations_, dt_s);
  const double lasts_s = std::min({delay_s, params.safety.acceleration_lasts_s, kLongestChange_s});
  opponents_.clear();
  for (const RobotState& robot : world.robots) {
    if (robot.id.team != theirs) continue;
    // Ours are where their lag will have carried them (controller.cc); theirs are looked at as of the same moment.
    const Vec2 coasted_to_m = robot.pose.position_m + params.drive_lag_s * robot.twist.velocity_mps;
    opponents_.push_back(
        accelerated(coasted_to_m, robot.twist.velocity_mps, accelerations_.of(robot.id), delay_s, lasts_s));
    opponents_.back().speed_max_mps = top_speed_.mps();
  }
  return opponents_;
}

}  // namespace regista
