#include "control/safety/safety_search.h"

#include <algorithm>
#include <numbers>

#include "control/motion_limits.h"
#include "planning/clearance.h"

namespace regista {
namespace {

/// Parts of the largest acceleration that are sampled.
constexpr std::array kMagnitudes{1.0, 2.0 / 3.0, 1.0 / 3.0};

}  // namespace

void SafetySearch::choose(std::span<const SafetyRobot> team, std::span<const Opponent> opponents,
                          const Surroundings& around, const RobotLimits& limits, const SafetyParams& params,
                          double period_s, std::vector<Vec2>& chosen_mps) {
  team_ = team;
  around_ = &around;
  limits_ = &limits;
  params_ = &params;
  period_s_ = period_s;
  promised_mps2_ = params.braking_share * limits.braking_max_mps2;
  opponents_.set(opponents, limits, params, period_s);
  promised_.clear();
  expected_.clear();
  for (const SafetyRobot& robot : team) {
    for (auto [motions, hold_s] : {std::pair{&promised_, 0.0}, std::pair{&expected_, params.hold_s}}) {
      motions->push_back(braking(robot.position_m, robot.velocity_mps, hold_s, promised_mps2_, period_s));
    }
  }
  chosen_mps.clear();
  for (std::size_t i = 0; i < team.size(); ++i) chosen_mps.push_back(choose_for(i));
}

Motion SafetySearch::motion_to(std::size_t robot, const Vec2& next_mps, double hold_s) const {
  const SafetyRobot& self = team_[robot];
  return manoeuvre(self.position_m, self.velocity_mps, next_mps, hold_s, promised_mps2_, period_s_);
}

/// All that can be reached in a period and is tried, nearest to the wanted velocity first.
void SafetySearch::sample(const SafetyRobot& robot) {
  samples_.clear();
  const double largest_mps = std::max(limits_->acceleration_max_mps2, limits_->braking_max_mps2) * period_s_;
  const auto add = [&](const Vec2& velocity_mps) {
    const Vec2 reachable =
        limited_velocity(robot.velocity_mps, clamped_norm(velocity_mps, robot.speed_max_mps), *limits_, period_s_);
    samples_.emplace_back((reachable - robot.wanted_mps).squaredNorm(), reachable);
  };
  add(Vec2::Zero());
  add(robot.velocity_mps);
  // Directions are counted from the wanted one, so that turning the field turns the answer.
  const Vec2 change = robot.wanted_mps - robot.velocity_mps;
  const Vec2 ahead = change.isZero(0.0) ? Vec2(Vec2::UnitX()) : Vec2(change.normalized());
  for (std::int64_t i = 0; i < params_->directions; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(params_->directions);
    const Vec2 direction = rotated(ahead, angle);
    const Vec2 furthest =
        limited_velocity(robot.velocity_mps, robot.velocity_mps + largest_mps * direction, *limits_, period_s_);
    for (const double magnitude : kMagnitudes) {
      add(robot.velocity_mps + magnitude * (furthest - robot.velocity_mps));
    }
  }
  std::stable_sort(samples_.begin(), samples_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
}

/// What was promised before anybody chose.
Vec2 SafetySearch::brake(std::size_t robot) {
  const Motion& promise = promised_[robot];
  expected_[robot] = promise;
  return promise.settled_s() > 0.0 ? velocity_after(promise.phases().front(), period_s_) : Vec2(Vec2::Zero());
}

/// Braking with all there is where that is as safe as what was promised.
Vec2 SafetySearch::stop(std::size_t robot) {
  Vec2 next_mps = limited_velocity(team_[robot].velocity_mps, Vec2::Zero(), *limits_, period_s_);
  const Motion motion = motion_to(robot, next_mps, 0.0);
  if (!is_clear_of_team(robot, motion, promised_) || !is_clear_of_shapes(robot, motion)) return brake(robot);
  promised_[robot] = motion;
  expected_[robot] = motion;
  return next_mps;
}

Vec2 SafetySearch::choose_for(std::size_t robot) {
  const SafetyRobot& self = team_[robot];
  if (self.must_stand) return stop(robot);
  Vec2 chosen = Vec2::Zero();
  Safety best = Safety::none;
  const auto consider = [&](const Vec2& next_mps) {
    const Motion motion = motion_to(robot, next_mps, 0.0);
    const Safety safety = safety_of(robot, next_mps, motion, best);
    // Who dodges slows down meanwhile: margins are gone, and what hits a slow robot is not its fault.
    const bool dodges_slower =
        safety == Safety::dodge && best == safety && next_mps.squaredNorm() < chosen.squaredNorm();
    if (safety > best || dodges_slower) {
      best = safety;
      chosen = next_mps;
      promised_candidate_ = motion;
    }
    return best == Safety::ahead;
  };
  const Vec2 wanted =
      limited_velocity(self.velocity_mps, clamped_norm(self.wanted_mps, self.speed_max_mps), *limits_, period_s_);
  if (!consider(wanted)) {
    sample(self);
    for (const auto& [distance, next_mps] : samples_) {
      if (consider(next_mps)) break;
    }
  }
  // Nothing is better than braking, which is always left, unless that comes to stand in the line of fire.
  const bool goes_through = (best == Safety::way_through || best == Safety::dodge) &&
                            opponents_.hit_within(promised_[robot], params_->way_through_s);
  if (best < Safety::opponents_brake && !goes_through) return brake(robot);
  promised_[robot] = promised_candidate_;
  expected_[robot] = motion_to(robot, chosen, params_->hold_s);
  return chosen;
}

SafetySearch::Safety SafetySearch::safety_of(std::size_t robot, const Vec2& next_mps, const Motion& motion,
                                             Safety best) const {
  if (!is_clear_of_team(robot, motion, promised_) || !is_clear_of_shapes(robot, motion)) return Safety::none;
  const bool is_clear_of_braking = opponents_.is_clear_of_braking(motion);
  if (!is_clear_of_braking && best >= Safety::opponents_brake) return Safety::none;
  if (!is_clear_of_expected(robot, next_mps, motion, Care::margins)) {
    if (is_clear_of_braking) return Safety::opponents_brake;
    return best <= Safety::dodge && is_clear_of_expected(robot, next_mps, motion, Care::half) ? Safety::dodge
                                                                                              : Safety::team;
  }
  if (!is_clear_of_braking) return Safety::way_through;
  if (!is_clear_of_expected(robot, next_mps, motion, Care::steady_too)) return Safety::opponents_expected;
  if (params_->hold_s <= 0.0) return Safety::ahead;
  return is_clear_of_team(robot, motion_to(robot, next_mps, params_->hold_s), expected_) ? Safety::ahead
                                                                                         : Safety::opponents_expected;
}

bool SafetySearch::is_clear_of_team(std::size_t robot, const Motion& motion, const std::vector<Motion>& others) const {
  const double wanted_m = 2.0 * limits_->radius_m + params_->team_margin_m;
  for (std::size_t other = 0; other < team_.size(); ++other) {
    if (other == robot) continue;
    if (!keep_apart(motion, others[other], {attainable_gap(wanted_m, motion, others[other])}, kNever)) return false;
  }
  return true;
}

bool SafetySearch::is_clear_of_shapes(std::size_t robot, const Motion& motion) const {
  const SafetyRobot& self = team_[robot];
  // Who was pushed out of bounds or into a shape must at least not go further out; shapes he is in are the planner's.
  const Vec2 extent = around_->half_extent_m.cwiseMax(self.position_m.cwiseAbs());
  if (!keeps_inside(motion, extent)) return false;
  for (std::size_t i = 0; i < around_->shapes.size(); ++i) {
    if (self.may_enter_own_area && i == around_->own_area) continue;
    const Obstacle& shape = around_->shapes[i];
    if (clearance(self.position_m, shape) <= 0.0) continue;
    if (!keeps_off(motion, shape, shape.radius_m)) return false;
  }
  return true;
}

/// Braking, driving on, or keeping the change of velocity up for a while must be clear of where each is expected. Only
/// of that: of team-mates and of what stands braking keeps clear, at every later tick too.
bool SafetySearch::is_clear_of_expected(std::size_t robot, const Vec2& next_mps, const Motion& motion,
                                        Care care) const {
  if (opponents_.is_clear_of_expected(motion, care)) return true;
  const SafetyRobot& self = team_[robot];
  const Vec2 change = (next_mps - self.velocity_mps) / period_s_;
  const auto is_clear_when_held = [&](const Vec2& acceleration, double hold_s) {
    return opponents_.is_clear_of_expected(sustained(self.position_m, self.velocity_mps, acceleration, hold_s,
                                                     self.speed_max_mps, period_s_, params_->horizon_s),
                                           care);
  };
  if (is_clear_when_held(change, period_s_)) return true;
  if (change.isZero(0.0)) return false;
  // What can be kept up, whichever way the velocity turns meanwhile.
  const Vec2 lasting = clamped_norm(change, limits_->acceleration_max_mps2);
  return is_clear_when_held(lasting, params_->evasion_short_s) || is_clear_when_held(lasting, params_->evasion_long_s);
}

}  // namespace regista
