#include "control/safety/opponent_models.h"

#include <algorithm>

#include "control/safety/separation.h"

namespace regista {
namespace {

/// cos² of the angle to straight back within which an acceleration is braking and no turn: 18°.
constexpr double kStraight = 0.9;

/// A touch of opponents later than this is not foreseen: until then they may turn.
constexpr double kForeseen_s = 0.6;

/// What is left of the margins where a robot would otherwise be hit.
constexpr double kHalf = 0.5;

Motion going_on(Motion motion, double for_s) {
  if (for_s > 0.0) motion.then(Vec2::Zero(), for_s);
  return motion;
}

/// An opponent that brakes is taken to go on until it stands; any other acceleration lasts for a while, and then
/// it drives on.
Motion expected_motion(const Opponent& opponent, const Touch& touch, double lasts_s, double horizon_s) {
  const Vec2& velocity = opponent.velocity_mps;
  Motion motion(opponent.position_m, velocity);
  if (touch.at_s < horizon_s) {
    motion = going_on(motion, touch.at_s);
    motion.then_hit(touch.change_mps);
    return going_on(motion, horizon_s - touch.at_s);
  }
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
  return going_on(motion, horizon_s - until_s);
}

}  // namespace

void OpponentModels::set(std::span<const Opponent> opponents, const RobotLimits& limits, const SafetyParams& params,
                         double period_s) {
  bodies_m_ = 2.0 * limits.radius_m;
  gap_m_ = bodies_m_ + params.opponent_margin_m;
  horizon_s_ = params.horizon_s;
  foresee_touches(opponents, bodies_m_, kForeseen_s, touches_);
  models_.clear();
  for (const Opponent& opponent : opponents) {
    const Touch& touch = touches_[models_.size()];
    Model& model = models_.emplace_back();
    model.braking = braking(opponent.position_m, opponent.velocity_mps, 0.0,
                            params.braking_share * limits.braking_max_mps2, period_s);
    model.expected = expected_motion(opponent, touch, params.acceleration_lasts_s, horizon_s_);
    model.steady = going_on({opponent.position_m, opponent.velocity_mps}, horizon_s_);
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

bool OpponentModels::is_clear_of_expected(const Motion& ours, Care care) const {
  const double share = care == Care::half ? kHalf : 1.0;
  const double gap_m = bodies_m_ + share * (gap_m_ - bodies_m_);
  return std::all_of(models_.begin(), models_.end(), [&](const Model& model) {
    const double there_m = attainable_gap(gap_m, ours, model.expected);
    if (care == Care::any_change && !keep_apart(ours, model.steady, {there_m}, horizon_s_)) return false;
    return keep_apart(ours, model.expected, {there_m, share * model.growth_mps}, horizon_s_);
  });
}

bool OpponentModels::hit_within(const Motion& ours, double within_s) const {
  return std::any_of(models_.begin(), models_.end(), [&](const Model& model) {
    return !keep_apart(ours, model.expected, {attainable_gap(bodies_m_, ours, model.expected)}, within_s);
  });
}

}  // namespace regista
