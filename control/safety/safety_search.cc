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

/// Parts of the largest acceleration that are sampled.
constexpr std::array kMagnitudes{1.0, 2.0 / 3.0, 1.0 / 3.0};

double attainable(double wanted_m, const Vec2& a, const Vec2& b) {
  return std::min(wanted_m, (a - b).norm() - kStill_m);
}

}  // namespace

void SafetySearch::choose(std::span<const SafetyRobot> team, std::span<const Opponent> opponents,
                          const Surroundings& around, const RobotLimits& limits, const SafetyParams& params,
                          double period_s, std::vector<Vec2>& chosen_mps) {
  team_ = team;
  around_ = &around;
  limits_ = &limits;
  params_ = &params;
  period_s_ = period_s;
  predict(opponents);
  promised_.clear();
  expected_.clear();
  for (const SafetyRobot& robot : team) {
    for (auto [motions, hold_s] : {std::pair{&promised_, 0.0}, std::pair{&expected_, params.hold_s}}) {
      motions->push_back(braking(robot.position_m, robot.velocity_mps, hold_s, limits.braking_max_mps2, period_s));
    }
  }
  chosen_mps.clear();
  for (std::size_t i = 0; i < team.size(); ++i) chosen_mps.push_back(choose_for(i));
}

void SafetySearch::predict(std::span<const Opponent> opponents) {
  opponents_.clear();
  const double lasts_s = std::min(params_->acceleration_lasts_s, params_->horizon_s);
  for (const Opponent& opponent : opponents) {
    OpponentModel model;
    model.braking = braking(opponent.position_m, opponent.velocity_mps, 0.0, limits_->braking_max_mps2, period_s_);
    model.predicted = Motion(opponent.position_m, opponent.velocity_mps);
    if (lasts_s > 0.0) model.predicted.then(opponent.acceleration_mps2, lasts_s);
    if (params_->horizon_s > lasts_s) model.predicted.then(Vec2::Zero(), params_->horizon_s - lasts_s);
    model.gap_m = 2.0 * limits_->radius_m + params_->opponent_margin_m;
    model.braking_gap_m = model.gap_m + params_->opponent_reaction_s * opponent.velocity_mps.norm();
    opponents_.push_back(model);
  }
}

Motion SafetySearch::motion_to(std::size_t robot, const Vec2& next_mps, double hold_s) const {
  const SafetyRobot& self = team_[robot];
  return manoeuvre(self.position_m, self.velocity_mps, next_mps, hold_s, limits_->braking_max_mps2, period_s_);
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

Vec2 SafetySearch::choose_for(std::size_t robot) {
  const SafetyRobot& self = team_[robot];
  Vec2 chosen = Vec2::Zero();
  Safety best = Safety::none;
  const auto consider = [&](const Vec2& next_mps) {
    const Motion motion = motion_to(robot, next_mps, 0.0);
    const Safety safety = safety_of(robot, next_mps, motion);
    if (safety > best) {
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
  // Not even against opponents that brake: nothing is better than braking, and braking is always left.
  if (best < Safety::opponents_brake) {
    const Motion& promise = promised_[robot];
    expected_[robot] = promise;
    return promise.settled_s() > 0.0 ? velocity_after(promise.phases().front(), period_s_) : Vec2(Vec2::Zero());
  }
  promised_[robot] = promised_candidate_;
  expected_[robot] = motion_to(robot, chosen, params_->hold_s);
  return chosen;
}

SafetySearch::Safety SafetySearch::safety_of(std::size_t robot, const Vec2& next_mps, const Motion& motion) const {
  if (!is_clear_of_team(robot, motion, promised_) || !is_clear_of_shapes(robot, motion)) return Safety::none;
  if (!is_clear_of_braking_opponents(robot, motion)) return Safety::team;
  if (!is_clear_of_predicted(robot, next_mps, motion)) return Safety::opponents_brake;
  if (params_->hold_s <= 0.0) return Safety::ahead;
  return is_clear_of_team(robot, motion_to(robot, next_mps, params_->hold_s), expected_) ? Safety::ahead
                                                                                         : Safety::opponents_predicted;
}

bool SafetySearch::is_clear_of_team(std::size_t robot, const Motion& motion, const std::vector<Motion>& others) const {
  const double wanted_m = 2.0 * limits_->radius_m + params_->team_margin_m;
  for (std::size_t other = 0; other < team_.size(); ++other) {
    if (other == robot) continue;
    const double gap_m = attainable(wanted_m, team_[robot].position_m, team_[other].position_m);
    if (!keep_apart(motion, others[other], {gap_m}, kNever)) return false;
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
    const double gap_m = attainable(opponent.braking_gap_m, position_m, opponent.braking.phases().front().position_m);
    return keep_apart(motion, opponent.braking, {gap_m}, kNever);
  });
}

/// Either braking or going on through must be clear of where each opponent is expected: who only ever brakes comes to
/// stand in the line of fire.
bool SafetySearch::is_clear_of_predicted(std::size_t robot, const Vec2& next_mps, const Motion& motion) const {
  const SafetyRobot& self = team_[robot];
  const auto keeps_apart_from_all = [&](const Motion& ours) {
    return std::all_of(opponents_.begin(), opponents_.end(), [&](const OpponentModel& opponent) {
      const double gap_m = attainable(opponent.gap_m, self.position_m, opponent.predicted.phases().front().position_m);
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
