#include "control/safety/safety_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "control/motion_limits.h"
#include "planning/clearance.h"

namespace regista {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Two that are already nearer than they should be must at least come no nearer; less than this is no way. Metres.
constexpr double kStill_m = 1e-9;

/// What rounding leaves of a time that is used up.
constexpr double kStill_s = 1e-9;

/// Parts of the largest acceleration that are sampled.
constexpr std::array kMagnitudes{1.0, 2.0 / 3.0, 1.0 / 3.0};

double attainable(double wanted_m, const Vec2& a, const Vec2& b) {
  return std::min(wanted_m, (a - b).norm() - kStill_m);
}

}  // namespace

void SafetySearch::choose(std::span<const SafetyRobot> team, std::span<const Opponent> opponents,
                          const Surroundings& around, const RobotLimits& limits, const SafetyParams& params,
                          double period_s, std::vector<SafeChoice>& chosen) {
  team_ = team;
  around_ = &around;
  limits_ = &limits;
  params_ = &params;
  period_s_ = period_s;
  predict(opponents);
  promised_.clear();
  for (const SafetyRobot& robot : team) {
    promised_.push_back(
        braking(robot.position_m, robot.velocity_mps, robot.hold_s, limits.braking_max_mps2, period_s));
  }
  chosen.clear();
  for (std::size_t i = 0; i < team.size(); ++i) chosen.push_back(choose_for(i));
}

void SafetySearch::predict(std::span<const Opponent> opponents) {
  opponents_.clear();
  const double lasts_s = std::min(params_->acceleration_lasts_s, params_->horizon_s);
  for (const Opponent& opponent : opponents) {
    OpponentModel model;
    model.braking =
        braking(opponent.position_m, opponent.velocity_mps, 0.0, limits_->braking_max_mps2, period_s_);
    model.predicted = Motion(opponent.position_m, opponent.velocity_mps);
    if (lasts_s > 0.0) model.predicted.then(opponent.acceleration_mps2, lasts_s);
    if (params_->horizon_s > lasts_s) model.predicted.then(Vec2::Zero(), params_->horizon_s - lasts_s);
    model.gap_m = 2.0 * limits_->radius_m + params_->opponent_margin_m;
    model.braking_gap_m = model.gap_m + params_->opponent_reaction_s * opponent.velocity_mps.norm();
    opponents_.push_back(model);
  }
}

Motion SafetySearch::motion_of(std::size_t robot, const SafeChoice& choice) const {
  const SafetyRobot& self = team_[robot];
  return manoeuvre(self.position_m, self.velocity_mps, choice.velocity_mps, choice.hold_s, limits_->braking_max_mps2,
                   period_s_);
}

/// All that can be reached in a period and is tried, nearest to the wanted velocity first.
void SafetySearch::sample(const SafetyRobot& robot) {
  samples_.clear();
  const double largest_mps = std::max(limits_->acceleration_max_mps2, limits_->braking_max_mps2) * period_s_;
  const auto add = [&](const Vec2& velocity_mps) {
    const Vec2 reachable = limited_velocity(
        robot.velocity_mps, clamped_norm(velocity_mps, robot.speed_max_mps), *limits_, period_s_);
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
    const Vec2 furthest = limited_velocity(robot.velocity_mps, robot.velocity_mps + largest_mps * direction, *limits_,
                                           period_s_);
    for (const double magnitude : kMagnitudes) {
      add(robot.velocity_mps + magnitude * (furthest - robot.velocity_mps));
    }
  }
  std::stable_sort(samples_.begin(), samples_.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
}

SafeChoice SafetySearch::choose_for(std::size_t robot) {
  const SafetyRobot& self = team_[robot];
  SafeChoice chosen;
  Motion promise;
  Safety best = Safety::none;
  const auto consider = [&](const Vec2& next_mps) {
    for (const double hold_s : {params_->hold_s, 0.0}) {
      const SafeChoice choice{next_mps, hold_s};
      const Motion motion = motion_of(robot, choice);
      const Safety safety = safety_of(robot, next_mps, motion);
      if (safety <= best) continue;
      best = safety;
      chosen = choice;
      promise = motion;
      if (best == Safety::opponents_predicted) return true;
    }
    return false;
  };
  const Vec2 wanted = limited_velocity(self.velocity_mps, clamped_norm(self.wanted_mps, self.speed_max_mps), *limits_,
                                       period_s_);
  if (!consider(wanted)) {
    sample(self);
    for (const auto& [distance, next_mps] : samples_) {
      if (consider(next_mps)) break;
    }
  }
  // Whoever would touch an opponent even if that one brakes can do no better than brake.
  if (best < Safety::opponents_brake) {
    best = Safety::none;
    consider(limited_velocity(self.velocity_mps, Vec2::Zero(), *limits_, period_s_));
    if (best == Safety::none) return keep_promise(robot);
  }
  promised_[robot] = promise;
  return chosen;
}

SafeChoice SafetySearch::keep_promise(std::size_t robot) const {
  const SafetyRobot& self = team_[robot];
  if (self.hold_s > kStill_s) return {self.velocity_mps, std::max(0.0, self.hold_s - period_s_)};
  const Motion& promise = promised_[robot];
  return {promise.settled_s() > 0.0 ? velocity_after(promise.phases().front(), period_s_) : Vec2(Vec2::Zero()), 0.0};
}

SafetySearch::Safety SafetySearch::safety_of(std::size_t robot, const Vec2& next_mps, const Motion& motion) const {
  if (!is_clear_of_team(robot, motion) || !is_clear_of_shapes(robot, motion)) return Safety::none;
  if (!is_clear_of_braking_opponents(robot, motion)) return Safety::team;
  return is_clear_of_predicted(robot, next_mps, motion) ? Safety::opponents_predicted : Safety::opponents_brake;
}

bool SafetySearch::is_clear_of_team(std::size_t robot, const Motion& motion) const {
  const double wanted_m = 2.0 * limits_->radius_m + params_->team_margin_m;
  for (std::size_t other = 0; other < team_.size(); ++other) {
    if (other == robot) continue;
    const double gap_m = attainable(wanted_m, team_[robot].position_m, team_[other].position_m);
    if (!keep_apart(motion, promised_[other], {gap_m}, kNever)) return false;
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

bool SafetySearch::is_clear_of_braking_opponents(std::size_t robot, const Motion& motion) const {
  const Vec2& position_m = team_[robot].position_m;
  return std::all_of(opponents_.begin(), opponents_.end(), [&](const OpponentModel& opponent) {
    const double gap_m =
        attainable(opponent.braking_gap_m, position_m, opponent.braking.phases().front().position_m);
    return keep_apart(motion, opponent.braking, {gap_m}, kNever);
  });
}

/// Either braking or going on through must be clear of where each opponent is expected: who only ever brakes comes to
/// stand in the line of fire.
bool SafetySearch::is_clear_of_predicted(std::size_t robot, const Vec2& next_mps, const Motion& motion) const {
  const SafetyRobot& self = team_[robot];
  const auto keeps_apart_from_all = [&](const Motion& ours) {
    return std::all_of(opponents_.begin(), opponents_.end(), [&](const OpponentModel& opponent) {
      const double gap_m =
          attainable(opponent.gap_m, self.position_m, opponent.predicted.phases().front().position_m);
      return keep_apart(ours, opponent.predicted, {gap_m}, params_->horizon_s);
    });
  };
  if (keeps_apart_from_all(motion)) return true;
  Motion through(self.position_m, self.velocity_mps);
  through.then((next_mps - self.velocity_mps) / period_s_, period_s_);
  through.then(Vec2::Zero(), params_->horizon_s);
  return keeps_apart_from_all(through);
}

}  // namespace regista
