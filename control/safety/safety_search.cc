#include "control/safety/safety_search.h"

#include <algorithm>

#include "control/motion_limits.h"
#include "planning/clearance.h"

namespace regista {

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

/// What was promised before anybody chose, and stays possible whatever others choose.
SafetySearch::Choice SafetySearch::braking_of(std::size_t robot) const {
  const Motion& motion = promised_[robot];
  if (motion.settled_s() == 0.0) return {Vec2::Zero(), motion};
  return {velocity_after(motion.phases().front(), period_s_), motion};
}

/// From now on others keep clear of it; they expect the robot to hold its velocity for a while before it brakes.
Vec2 SafetySearch::promise(std::size_t robot, const Choice& choice, double hold_s) {
  promised_[robot] = choice.motion;
  expected_[robot] = hold_s > 0.0 ? motion_to(robot, choice.next_mps, hold_s) : choice.motion;
  return choice.next_mps;
}

/// Braking with all there is where that is as safe as what was promised.
Vec2 SafetySearch::stop(std::size_t robot) {
  const Vec2 next_mps = limited_velocity(team_[robot].velocity_mps, Vec2::Zero(), *limits_, period_s_);
  const Choice hardest{next_mps, motion_to(robot, next_mps, 0.0)};
  return promise(robot, is_possible(robot, hardest.motion) ? hardest : braking_of(robot), 0.0);
}

Vec2 SafetySearch::choose_for(std::size_t robot) {
  const SafetyRobot& self = team_[robot];
  if (self.must_stand) return stop(robot);
  opponents_.set_robot(promised_[robot]);
  Choice chosen;
  Safety best = Safety::none;
  const auto consider = [&](const Vec2& next_mps) {
    const Choice choice{next_mps, motion_to(robot, next_mps, 0.0)};
    const Safety safety = safety_of(robot, choice, best);
    if (safety > best) {
      best = safety;
      chosen = choice;
    }
    return best == Safety::ahead;
  };
  const Vec2 wanted =
      limited_velocity(self.velocity_mps, clamped_norm(self.wanted_mps, self.speed_max_mps), *limits_, period_s_);
  if (!consider(wanted)) {
    sample_velocities(self, *limits_, params_->directions, period_s_, samples_);
    for (const auto& [distance, next_mps] : samples_) {
      if (consider(next_mps)) break;
    }
  }
  if (best >= Safety::opponents_expected) return promise(robot, chosen, params_->hold_s);
  // Braking is held to what it is: who brakes to dodge a little later could as well dodge now, and drive on.
  const bool is_clear_of_braking = best == Safety::opponents_brake;
  const Choice instead = is_clear_of_braking ? chosen : braking_of(robot);
  const double cost = is_clear_of_braking ? crash_cost(robot, chosen) : opponents_.crash_cost(instead.motion);
  return promise(robot, lightest_crash(robot, instead, cost), params_->hold_s);
}

/// Where no evasion is clear of where opponents are expected, the possible velocity that ends best; `instead` if none
/// costs less than that.
SafetySearch::Choice SafetySearch::lightest_crash(std::size_t robot, const Choice& instead, double cost_of_it) const {
  Choice lightest = instead;
  double least = cost_of_it;
  for (const auto& [distance, next_mps] : samples_) {
    if (least <= 0.0) break;
    const Choice choice{next_mps, motion_to(robot, next_mps, 0.0)};
    const double cost = crash_cost(robot, choice);
    if (cost >= least || !is_possible(robot, choice.motion)) continue;
    least = cost;
    lightest = choice;
  }
  return lightest;
}

SafetySearch::Safety SafetySearch::safety_of(std::size_t robot, const Choice& choice, Safety best) const {
  if (!is_possible(robot, choice.motion) || !opponents_.is_clear_of_braking(choice.motion)) return Safety::none;
  if (best < Safety::opponents_expected && !is_clear_of_expected(robot, choice, Care::margins)) {
    return Safety::opponents_brake;
  }
  const bool is_ahead = is_clear_of_expected(robot, choice, Care::steady_too) &&
                        (params_->hold_s <= 0.0 ||
                         is_clear_of_team(robot, motion_to(robot, choice.next_mps, params_->hold_s), expected_));
  return is_ahead ? Safety::ahead : Safety::opponents_expected;
}

/// Of the evasion that ends best.
double SafetySearch::crash_cost(std::size_t robot, const Choice& choice) const {
  double least = kNever;
  any_evasion(robot, choice, [&](const Motion& motion) {
    least = std::min(least, opponents_.crash_cost(motion));
    return least <= 0.0;
  });
  return least;
}

bool SafetySearch::is_possible(std::size_t robot, const Motion& motion) const {
  return is_clear_of_team(robot, motion, promised_) && is_clear_of_shapes(robot, motion);
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

bool SafetySearch::is_clear_of_expected(std::size_t robot, const Choice& choice, Care care) const {
  return any_evasion(robot, choice,
                     [&](const Motion& motion) { return opponents_.is_clear_of_expected(motion, care); });
}

/// Braking, driving on, or keeping the change of velocity up for a while: true as soon as one is enough. They are only
/// held against opponents: of team-mates and of what stands braking keeps clear, at every later tick too.
template <class Judge>
bool SafetySearch::any_evasion(std::size_t robot, const Choice& choice, Judge&& is_enough) const {
  if (is_enough(choice.motion)) return true;
  const SafetyRobot& self = team_[robot];
  const Vec2 change = (choice.next_mps - self.velocity_mps) / period_s_;
  const auto is_enough_when_held = [&](const Vec2& acceleration, double hold_s) {
    return is_enough(sustained(self.position_m, self.velocity_mps, acceleration, hold_s, self.speed_max_mps, period_s_,
                               params_->horizon_s));
  };
  if (is_enough_when_held(change, period_s_)) return true;
  if (change.isZero(0.0)) return false;
  // What can be kept up, whichever way the velocity turns meanwhile.
  const Vec2 lasting = clamped_norm(change, limits_->acceleration_max_mps2);
  return is_enough_when_held(lasting, params_->evasion_short_s) ||
         is_enough_when_held(lasting, params_->evasion_long_s);
}

}  // namespace regista
