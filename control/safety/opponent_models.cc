#include "control/safety/opponent_models.h"

#include <algorithm>

#include "control/safety/separation.h"

namespace regista {
namespace {

/// cos² of the angle to straight back within which an acceleration is braking and no turn: 18°.
constexpr double kStraight = 0.9;

/// An opponent that brakes is taken to go on until it stands; any other acceleration lasts for a while, and then
/// it drives on.
Motion expected_motion(const Opponent& opponent, double lasts_s, double horizon_s) {
  const Vec2& velocity = opponent.velocity_mps;
  Motion motion(opponent.position_m, velocity);
  const double against = -opponent.acceleration_mps2.dot(velocity);
  const double speed2 = velocity.squaredNorm();
  const bool brakes = lasts_s > 0.0 && against > 0.0 &&
                      against * against > kStraight * opponent.acceleration_mps2.squaredNorm() * speed2;
  if (brakes && speed2 < against * horizon_s) {
    motion.then_stand(-(against / speed2) * velocity, speed2 / against);
    return motion;
  }
  const double until_s = brakes ? horizon_s : std::min(lasts_s, horizon_s);
  if (until_s > 0.0) motion.then(opponent.acceleration_mps2, until_s);
  if (horizon_s > until_s) motion.then(Vec2::Zero(), horizon_s - until_s);
  return motion;
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
    model.braking = braking(opponent.position_m, opponent.velocity_mps, 0.0,
                            params.braking_share * limits.braking_max_mps2, period_s);
    model.expected = expected_motion(opponent, params.acceleration_lasts_s, horizon_s_);
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
