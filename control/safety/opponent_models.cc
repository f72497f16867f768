#include "control/safety/opponent_models.h"

#include <algorithm>

#include "control/safety/separation.h"

namespace regista {
namespace {

/// cos² of the angle to straight back within which an acceleration is braking and no turn: 18°.
constexpr double kStraight = 0.9;

/// A touch of opponents later than this is not foreseen: until then they may turn.
constexpr double kForeseen_s = 0.6;

/// Robots side by side that graze go where they would have gone. Less than this is noise.
constexpr double kSlight_mps = 0.3;

/// What is left of the margins where a robot would otherwise be hit.
constexpr double kHalf = 0.5;

Motion with(Motion motion, const Vec2& acceleration_mps2, double for_s) {
  if (for_s > 0.0) motion.then(acceleration_mps2, for_s);
  return motion;
}

/// An opponent that brakes is taken to go on until it stands; any other acceleration lasts for a while, and then it
/// drives on. Who hits another one before goes on with it: what it wanted tells nothing any more.
Motion expected_motion(const Opponent& opponent, const Touch& touch, double lasts_s, double horizon_s) {
  const Vec2& velocity = opponent.velocity_mps;
  const Vec2& acceleration = opponent.acceleration_mps2;
  Motion motion(opponent.position_m, velocity);
  const double against = -acceleration.dot(velocity);
  const double speed2 = velocity.squaredNorm();
  const bool brakes =
      lasts_s > 0.0 && against > 0.0 && against * against > kStraight * acceleration.squaredNorm() * speed2;
  const double touch_s = touch.change_mps.norm() > kSlight_mps ? touch.at_s : Touch{}.at_s;
  if (brakes && speed2 < against * std::min(touch_s, horizon_s)) {
    motion.then_stand(-(against / speed2) * velocity, speed2 / against);
    return motion;
  }
  if (touch_s < horizon_s) {
    motion = with(motion, Vec2::Zero(), touch_s);
    motion.hit(touch.change_mps);
    return with(motion, Vec2::Zero(), horizon_s - touch_s);
  }
  const double until_s = brakes ? horizon_s : std::min(lasts_s, horizon_s);
  motion = with(motion, acceleration, until_s);
  return with(motion, Vec2::Zero(), horizon_s - until_s);
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
    model.steady = with({opponent.position_m, opponent.velocity_mps}, Vec2::Zero(), horizon_s_);
    const double speed = opponent.velocity_mps.norm();
    model.braking_gap_m = gap_m_ + params.opponent_reaction_s * speed;
    model.growth_mps = params.opponent_growth * speed;
  }
}

bool OpponentModels::is_clear_of_braking(const Motion& ours) const {
  return all([&](const Model& model) {
    return keep_apart(ours, model.braking, {attainable_gap(model.braking_gap_m, ours, model.braking)}, kNever);
  });
}

bool OpponentModels::is_clear_of_expected(const Motion& ours, Care care) const {
  const double share = care == Care::half ? kHalf : 1.0;
  const double gap_m = bodies_m_ + share * (gap_m_ - bodies_m_);
  return all([&](const Model& model) {
    const double there_m = attainable_gap(gap_m, ours, model.expected);
    if (care == Care::steady_too && !keep_apart(ours, model.steady, {there_m}, horizon_s_)) return false;
    return keep_apart(ours, model.expected, {there_m, share * model.growth_mps}, horizon_s_);
  });
}

bool OpponentModels::hit_within(const Motion& ours, double within_s) const {
  return !all([&](const Model& model) {
    return keep_apart(ours, model.expected, {attainable_gap(bodies_m_, ours, model.expected)}, within_s);
  });
}

}  // namespace regista
