#include "control/safety/opponent_models.h"

#include <algorithm>

#include "control/safety/separation.h"

namespace regista {

void OpponentModels::set(std::span<const Opponent> opponents, const RobotLimits& limits, const SafetyParams& params,
                         double period_s) {
  bodies_m_ = 2.0 * limits.radius_m;
  gap_m_ = bodies_m_ + params.opponent_margin_m;
  growth_mps_ = params.opponent_growth_mps;
  horizon_s_ = params.horizon_s;
  const double lasts_s = std::min(params.acceleration_lasts_s, horizon_s_);
  models_.clear();
  for (const Opponent& opponent : opponents) {
    Model& model = models_.emplace_back();
    model.braking = braking(opponent.position_m, opponent.velocity_mps, 0.0, limits.braking_max_mps2, period_s);
    model.expected = Motion(opponent.position_m, opponent.velocity_mps);
    if (lasts_s > 0.0) model.expected.then(opponent.acceleration_mps2, lasts_s);
    if (horizon_s_ > lasts_s) model.expected.then(Vec2::Zero(), horizon_s_ - lasts_s);
    model.braking_gap_m = gap_m_ + params.opponent_reaction_s * opponent.velocity_mps.norm();
  }
}

bool OpponentModels::is_clear_of_braking(const Motion& ours) const {
  return std::all_of(models_.begin(), models_.end(), [&](const Model& model) {
    return keep_apart(ours, model.braking, {attainable_gap(model.braking_gap_m, ours, model.braking)}, kNever);
  });
}

bool OpponentModels::is_clear_of_expected(const Motion& ours) const {
  return std::all_of(models_.begin(), models_.end(), [&](const Model& model) {
    return keep_apart(ours, model.expected, {attainable_gap(gap_m_, ours, model.expected), growth_mps_}, horizon_s_);
  });
}

bool OpponentModels::hit_within(const Motion& ours, double within_s) const {
  return std::any_of(models_.begin(), models_.end(), [&](const Model& model) {
    return !keep_apart(ours, model.expected, {attainable_gap(bodies_m_, ours, model.expected)}, within_s);
  });
}

}  // namespace regista
