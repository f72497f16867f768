#include "control/safety/opponent_models.h"

#include <algorithm>
#include <array>

#include "control/safety/expected_motion.h"
#include "control/safety/separation.h"
#include "world_model/types/crash_rule.h"

namespace regista {
namespace {

/// A touch of opponents later than this is not foreseen: until then they may turn.
constexpr double kForeseen_s = 0.6;

/// Who drives and touches another one, or will so soon if both go on, is jostled: where it gets to nobody knows, least
/// of all where the two press on each other or graze. Its margin grows by so much more. Nothing is gained where hard
/// hits alone count, or where this grows with the speed.
constexpr double kJostledWithin_s = 0.2;
constexpr double kJostledFrom_mps = 0.3;  ///< slower ones may stand in a wall, and vision shakes them
constexpr double kJostledGrowth_mps = 0.2;

/// A crash that is so near to being our foul counts as one: by then a velocity is another one.
constexpr double kNearlyFoul_mps = 0.4;
/// What 1 m/s of a crash counts that is not our foul, against 1 for a foul.
constexpr double kNoFoul = 0.1;
/// What a crash at the horizon counts, against one now.
constexpr double kAtHorizon = 0.5;

/// Parts of an opponent's reaction among which the room left for it is rounded up.
constexpr std::array kRooms{0.0, 1.0 / 16.0, 1.0 / 8.0, 1.0 / 4.0, 1.0 / 2.0, 3.0 / 4.0};
constexpr double kUnasked_m = -1.0;

/// Of two motions that come as near as the margin at that moment.
double cost_of_touch(const Motion& ours, const Motion& theirs, double at_s) {
  const Phase& our_phase = ours.phase_at(at_s);
  const Phase& their_phase = theirs.phase_at(at_s);
  const double our_s = at_s - our_phase.begin_s;
  const double their_s = at_s - their_phase.begin_s;
  const Vec2 normal = (position_after(their_phase, their_s) - position_after(our_phase, our_s)).stableNormalized();
  const double towards_mps = velocity_after(our_phase, our_s).dot(normal);
  const double their_towards_mps = -velocity_after(their_phase, their_s).dot(normal);
  const double excess_mps = foul_excess(towards_mps, their_towards_mps);
  return excess_mps > -kNearlyFoul_mps ? 1.0 + excess_mps : kNoFoul * std::max(0.0, towards_mps + their_towards_mps);
}

}  // namespace

void OpponentModels::set(std::span<const Opponent> opponents, const RobotLimits& limits, const SafetyParams& params,
                         double period_s) {
  const double bodies_m = 2.0 * limits.radius_m;
  gap_m_ = bodies_m + params.opponent_margin_m;
  horizon_s_ = params.horizon_s;
  crash_horizon_s_ = params.crash_horizon_s;
  foresee_touches(opponents, bodies_m, kForeseen_s, touches_);
  models_.clear();
  our_braking_ = nullptr;
  for (const Opponent& opponent : opponents) {
    const Touch& touch = touches_[models_.size()];
    Model& model = models_.emplace_back();
    model.braking = braking(opponent.position_m, opponent.velocity_mps, 0.0,
                            params.braking_share * limits.braking_max_mps2, period_s);
    model.expected = expected_motion(opponent, touch, params);
    model.steady = Motion(opponent.position_m, opponent.velocity_mps);
    model.steady.then(Vec2::Zero(), horizon_s_);
    const double speed = opponent.velocity_mps.norm();
    model.reaction_m = params.opponent_reaction_s * speed;
    const bool is_jostled = touch.at_s < kJostledWithin_s && speed > kJostledFrom_mps;
    model.growth_mps = params.opponent_growth * speed + (is_jostled ? kJostledGrowth_mps : 0.0);
  }
}

void OpponentModels::set_robot(const Motion& braking) {
  our_braking_ = &braking;
  rooms_m_.assign(models_.size(), kUnasked_m);
}

/// What has to be left for the opponent's next choice. Half of what is between both when both brake is rounded up.
double OpponentModels::room_for(const Model& model) const {
  if (our_braking_ == nullptr) return model.reaction_m;
  double& room_m = rooms_m_[static_cast<std::size_t>(&model - models_.data())];
  if (room_m != kUnasked_m) return room_m;
  room_m = model.reaction_m;
  for (const double share : kRooms) {
    const double half_m = share * model.reaction_m;
    if (keep_apart(*our_braking_, model.braking, {gap_m_ + 2.0 * half_m}, kNever)) continue;
    room_m = half_m;
    break;
  }
  return room_m;
}

bool OpponentModels::is_clear_of_braking(const Motion& ours) const {
  return all([&](const Model& model) {
    const auto leaves = [&](double room_m) {
      return keep_apart(ours, model.braking, {attainable_gap(gap_m_ + room_m, ours, model.braking)}, kNever);
    };
    return leaves(model.reaction_m) || (room_for(model) < model.reaction_m && leaves(room_for(model)));
  });
}

bool OpponentModels::is_clear_of_expected(const Motion& ours, Care care) const {
  return all([&](const Model& model) {
    const double there_m = attainable_gap(gap_m_, ours, model.expected);
    if (care == Care::steady_too && !keep_apart(ours, model.steady, {there_m}, horizon_s_)) return false;
    return keep_apart(ours, model.expected, {there_m, model.growth_mps}, horizon_s_);
  });
}

double OpponentModels::crash_cost(const Motion& ours) const {
  double worst = 0.0;
  for (const Model& model : models_) {
    const Gap gap{attainable_gap(gap_m_, ours, model.expected)};
    const double at_s = time_to_contact(ours, model.expected, gap, crash_horizon_s_);
    if (at_s >= crash_horizon_s_) continue;
    const double certainty = 1.0 - (1.0 - kAtHorizon) * at_s / crash_horizon_s_;
    worst = std::max(worst, certainty * cost_of_touch(ours, model.expected, at_s));
  }
  return worst;
}

}  // namespace regista
