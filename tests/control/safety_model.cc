#include "tests/control/safety_model.h"

#include <numbers>

#include "control/motion_limits.h"
#include "planning/clearance.h"
#include "tests/support/exact_motion.h"

namespace regista::testing {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Standing still is a motion too.
Vec2 position_at(const Motion& motion, double t) {
  const std::span<const Phase> phases = motion.phases();
  std::size_t i = phases.size() - 1;
  while (i > 0 && phases[i].begin_s > t) --i;
  return position_after(phases[i], t - phases[i].begin_s);
}

class Model {
 public:
  Model(const SafeTeam& team, Flaw flaw) : team_(team), flaw_(flaw) {
    for (const SafetyRobot& robot : team.robots) {
      Motion motion(robot.position_m, robot.velocity_mps);
      brake(motion, robot.velocity_mps);
      before_.push_back(motion);
    }
    promised_ = before_;
  }

  Vec2 choose(std::size_t robot) {
    const std::vector<Vec2> candidates = sorted_candidates(team_.robots[robot]);
    for (const Vec2& next_mps : candidates) {
      const Motion motion = to(robot, next_mps);
      if (is_safe(robot, motion)) return promise(robot, next_mps, motion);
    }
    if (flaw_ == Flaw::least_bad) {
      const Vec2 next_mps = least_bad(robot, candidates);
      return promise(robot, next_mps, to(robot, next_mps));
    }
    const Phase& first = before_[robot].phases().front();
    if (first.velocity_mps.isZero(0.0)) return Vec2::Zero();
    if (flaw_ != Flaw::partial_periods) return velocity_after(first, team_.period_s);
    const double speed = first.velocity_mps.norm();
    return first.velocity_mps * std::max(0.0, 1.0 - team_.limits.braking_max_mps2 * team_.period_s / speed);
  }

 private:
  void brake(Motion& motion, const Vec2& velocity_mps) const {
    const double speed = velocity_mps.norm();
    if (speed == 0.0) return;
    const double shortest_s = speed / team_.limits.braking_max_mps2;
    const double whole_s = std::max(1.0, std::ceil(shortest_s / team_.period_s - 1e-6)) * team_.period_s;
    const double duration_s = flaw_ == Flaw::partial_periods ? shortest_s : whole_s;
    motion.then_stand(-velocity_mps / duration_s, duration_s);
  }

  Motion to(std::size_t robot, const Vec2& next_mps) const {
    const SafetyRobot& self = team_.robots[robot];
    Motion motion(self.position_m, self.velocity_mps);
    motion.then((next_mps - self.velocity_mps) / team_.period_s, team_.period_s);
    brake(motion, next_mps);
    return motion;
  }

  Vec2 promise(std::size_t robot, const Vec2& next_mps, const Motion& motion) {
    if (flaw_ != Flaw::simultaneous) promised_[robot] = motion;
    return next_mps;
  }

  std::vector<Vec2> sorted_candidates(const SafetyRobot& robot) const {
    const RobotLimits& limits = team_.limits;
    const double largest_mps = std::max(limits.acceleration_max_mps2, limits.braking_max_mps2) * team_.period_s;
    const auto reachable = [&](const Vec2& velocity_mps) {
      return limited_velocity(robot.velocity_mps, clamped_norm(velocity_mps, robot.speed_max_mps), limits,
                              team_.period_s);
    };
    const Vec2 change = robot.wanted_mps - robot.velocity_mps;
    const Vec2 ahead = change.isZero(0.0) ? Vec2(Vec2::UnitX()) : Vec2(change.normalized());
    std::vector<Vec2> out{reachable(Vec2::Zero()), reachable(robot.velocity_mps)};
    for (std::int64_t i = 0; i < team_.params.directions; ++i) {
      const double angle =
          2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(team_.params.directions);
      const Vec2 furthest_mps = limited_velocity(
          robot.velocity_mps, robot.velocity_mps + largest_mps * rotated(ahead, angle), limits, team_.period_s);
      for (const double part : {1.0, 2.0 / 3.0, 1.0 / 3.0}) {
        out.push_back(reachable(robot.velocity_mps + part * (furthest_mps - robot.velocity_mps)));
      }
    }
    std::stable_sort(out.begin(), out.end(), [&](const Vec2& a, const Vec2& b) {
      return (a - robot.wanted_mps).squaredNorm() < (b - robot.wanted_mps).squaredNorm();
    });
    out.insert(out.begin(), reachable(robot.wanted_mps));
    return out;
  }

  bool is_safe(std::size_t robot, const Motion& motion) const {
    for (std::size_t other = 0; other < promised_.size(); ++other) {
      if (other != robot && !keeps_apart(robot, motion, other)) return false;
    }
    return is_clear_of_hall(robot, motion);
  }

  bool is_clear_of_hall(std::size_t robot, const Motion& motion) const {
    const Vec2& here_m = team_.robots[robot].position_m;
    if (!keeps_inside(motion, team_.around.half_extent_m.cwiseMax(here_m.cwiseAbs()))) return false;
    return std::all_of(team_.around.shapes.begin(), team_.around.shapes.end(), [&](const Obstacle& shape) {
      return clearance(here_m, shape) <= 0.0 || keeps_off(motion, shape, shape.radius_m);
    });
  }

  bool keeps_apart(std::size_t robot, const Motion& motion, std::size_t other) const {
    const SafetyRobot& self = team_.robots[robot];
    const double now_m = (self.position_m - team_.robots[other].position_m).norm();
    const double wanted_m = 2.0 * team_.limits.radius_m + team_.params.team_margin_m;
    if (flaw_ == Flaw::ignores_margin_breakers && now_m <= wanted_m) return true;
    if (flaw_ == Flaw::own_reach_only) {
      const double speed = self.velocity_mps.norm() + team_.limits.acceleration_max_mps2 * team_.period_s;
      const double reach_m = speed * team_.period_s + speed * speed / (2.0 * team_.limits.braking_max_mps2);
      if (now_m > wanted_m + reach_m) return true;
    }
    const double gap_m = flaw_ == Flaw::insists_on_margin ? wanted_m : std::min(wanted_m, now_m - 1e-9);
    if (flaw_ == Flaw::sampled) return nearest_of_samples(motion, promised_[other]) > gap_m;
    return keep_apart(motion, promised_[other], {gap_m}, kNever);
  }

  double nearest_of_samples(const Motion& a, const Motion& b) const {
    double least_m = kNever;
    for (double t = 0.0; t <= std::max(a.settled_s(), b.settled_s()) + team_.period_s / 2.0; t += team_.period_s) {
      least_m = std::min(least_m, (position_at(a, t) - position_at(b, t)).norm());
    }
    return least_m;
  }

  Vec2 least_bad(std::size_t robot, std::span<const Vec2> candidates) const {
    Vec2 best = candidates.front();
    double most_m = -1.0;
    for (const Vec2& next_mps : candidates) {
      const Motion motion = to(robot, next_mps);
      if (!is_clear_of_hall(robot, motion)) continue;
      double least_m = 3.0 * team_.limits.radius_m;
      for (std::size_t other = 0; other < promised_.size(); ++other) {
        if (other != robot) least_m = least_distance(motion, promised_[other], least_m);
      }
      if (least_m <= most_m) continue;
      most_m = least_m;
      best = next_mps;
    }
    return best;
  }

  const SafeTeam& team_;
  Flaw flaw_;
  std::vector<Motion> before_;    ///< all braking, by robot
  std::vector<Motion> promised_;  ///< likewise, as far as chosen
};

}  // namespace

std::vector<Vec2> model_choice(const SafeTeam& team, Flaw flaw) {
  Model model(team, flaw);
  std::vector<Vec2> chosen_mps;
  for (std::size_t i = 0; i < team.robots.size(); ++i) chosen_mps.push_back(model.choose(i));
  return chosen_mps;
}

}  // namespace regista::testing
