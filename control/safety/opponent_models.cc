#include "control/safety/opponent_models.h"

#include <algorithm>

#include "control/safety/separation.h"

namespace regista {
namespace {

/// An opponent that mainly brakes is taken to go on until it stands; any other acceleration lasts so long.
double lasting_s(const Opponent& opponent, double lasts_s, double horizon_s) {
  const double against = -opponent.acceleration_mps2.dot(opponent.velocity_mps);
  const double speed2 = opponent.velocity_mps.squaredNorm();
  const bool brakes = against > 0.0 && 2.0 * against * against > opponent.acceleration_mps2.squaredNorm() * speed2;
  return std::min(brakes ? std::max(lasts_s, speed2 / against) : lasts_s, horizon_s);
}

}  // namespace

void OpponentModels::set(std::span<const Opponent> opponents, const RobotLimits& limits, const SafetyParams& params,
                         double period_s) {
  bodies_m_ = 2.0 * limits.radius_m;
  gap_m_ = bodies_m_ + params.opponent_margin_m;
  horizon_s_ = params.horizon_s;
  models_.clear();
  for (const Opponent& opponent : opponents) {
    Model& model = models_.emplace_back();
    model.braking = braking(opponent.position_m, opponent.velocity_mps, 0.0, limits.braking_max_mps2, period_s);
    const double lasts_s = lasting_s(opponent, params.acceleration_lasts_s, horizon_s_);
    model.expected = Motion(opponent.position_m, opponent.velocity_mps);
    if (lasts_s > 0.0) model.expected.then(opponent.acceleration_mps2, lasts_s);
    if (horizon_s_ > lasts_s) model.expected.then(Vec2::Zero(), horizon_s_ - lasts_s);
    const double speed = opponent.velocity_mps.norm();
    model.braking_gap_m = gap_m_ + params.opponent_reaction_s * speed;
    model.growth_mps = params.opponent_growth * speed;
  }
}

bool OpponentModels::is_clear_of_braking(const Motion& ours) const {
  return std::all_of(models_.begin(), models_.end(), [&](const Model& model) {
    return keep_apart(ours, model.braking, {attainable_gap(model.braking_gap_m, ours, model.braking)}, kNever);
  });
}

bool OpponentModels::is_clear_of_expected(const Motion& ours) const {
  return std::all_of(models_.begin(), models_.end(), [&](const Model& model) {
    return keep_apart(ours, model.expected, {attainable_gap(gap_m_, ours, model.expected), model.growth_mps},
                      horizon_s_);
  });
}

bool OpponentModels::hit_within(const Motion& ours, double within_s) const {
  return std::any_of(models_.begin(), models_.end(), [&](const Model& model) {
    return !keep_apart(ours, model.expected, {attainable_gap(bodies_m_, ours, model.expected)}, within_s);
  });
}

}  // namespace regista
