// Dynamic safety search for a team (after Bruce & Veloso, "Safe multirobot navigation within dynamics constraints",
// Proc. IEEE 94(7), 2006): after every reachable velocity it is asked whether the robot can still brake to a stand
// without touching anything, and how well it keeps clear of opponents and of where team-mates are expected (Safety).
// The safest velocity is taken, of equally safe ones the nearest to the wanted one. Where none keeps clear of where
// opponents are expected, the one with the lightest crash: late, slow, and no foul of ours.
//
// Why team-mates never touch while robots do as they are told: at the start of a tick all of them braking is free of
// contact. Robots choose one after another; whoever has chosen has promised "this period, then brake", whoever has not
// is bound to brake. A choice is checked against those promises in continuous time, and braking itself is always left,
// for everybody's earlier choice was checked against it. Braking takes whole periods, so at the next tick the rest of
// each promise is exactly "brake", and the argument starts anew.
#pragma once

#include <span>
#include <vector>

#include "control/safety/motion.h"
#include "control/safety/opponent_models.h"
#include "control/safety/safety_params.h"
#include "control/safety/safety_robot.h"
#include "control/safety/separation.h"
#include "control/safety/surroundings.h"
#include "control/safety/velocity_samples.h"

namespace regista {

class SafetySearch {
 public:
  /// The velocities after this period, one per robot of `team` and reachable within limits. Deterministic; ties go to
  /// the sample generated first. The promises only hold while all robots of the team are here and period_s > 0 stays
  /// the same.
  void choose(std::span<const SafetyRobot> team, std::span<const Opponent> opponents, const Surroundings& around,
              const RobotLimits& limits, const SafetyParams& params, double period_s, std::vector<Vec2>& chosen_mps);

 private:
  /// How much of what is wanted of a motion holds, by rank. All but `none` keep clear of the team's promises, of what
  /// stands, and of opponents that brake. From `opponents_expected` on: of where opponents are expected too. `ahead`:
  /// also of opponents that keep their velocities and of where team-mates are expected.
  enum class Safety { none, opponents_brake, opponents_expected, ahead };
  /// A velocity after this period and what it promises: to brake then.
  struct Choice {
    Vec2 next_mps = Vec2::Zero();
    Motion motion;
  };

  Vec2 choose_for(std::size_t robot);
  Vec2 stop(std::size_t robot);
  Choice lightest_crash(std::size_t robot, const Choice& instead, double cost_of_it) const;
  Vec2 promise(std::size_t robot, const Choice& choice, double hold_s);
  Choice braking_of(std::size_t robot) const;
  /// Exact where it is more than `best`; else no more than that.
  Safety safety_of(std::size_t robot, const Choice& choice, Safety best) const;
  double crash_cost(std::size_t robot, const Choice& choice) const;
  bool is_possible(std::size_t robot, const Motion& motion) const;
  bool is_clear_of_team(std::size_t robot, const Motion& motion, const std::vector<Motion>& others) const;
  bool is_clear_of_shapes(std::size_t robot, const Motion& motion) const;
  bool is_clear_of_expected(std::size_t robot, const Choice& choice, Care care) const;
  template <class Judge>
  bool any_evasion(std::size_t robot, const Choice& choice, Judge&& is_enough) const;
  Motion motion_to(std::size_t robot, const Vec2& next_mps, double hold_s) const;

  // Of the call that is being answered.
  std::span<const SafetyRobot> team_;
  const Surroundings* around_ = nullptr;
  const RobotLimits* limits_ = nullptr;
  const SafetyParams* params_ = nullptr;
  double period_s_ = 0.0;
  double promised_mps2_ = 0.0;    ///< how hard braking is counted on
  std::vector<Motion> promised_;  ///< by robot
  std::vector<Motion> expected_;  ///< likewise: holds its velocity for a while before it brakes
  OpponentModels opponents_;
  std::vector<VelocitySample> samples_;
};

}  // namespace regista
