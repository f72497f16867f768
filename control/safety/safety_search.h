// Dynamic safety search for a team (after Bruce & Veloso, "Safe multirobot navigation within dynamics constraints",
// Proc. IEEE 94(7), 2006): after every reachable velocity it is asked whether the robot can still brake to a stand
// without touching anything, and how well it keeps clear of opponents and of where team-mates are expected (Safety).
// The safest velocity is taken, of equally safe ones the nearest to the wanted one; of those that only dodge, the
// slowest.
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
#include "control/safety/separation.h"
#include "control/safety/surroundings.h"

namespace regista {

/// One of ours, as its commands move it: the velocity it has been told, and where that begins to act.
struct SafetyRobot {
  Vec2 position_m = Vec2::Zero();
  Vec2 velocity_mps = Vec2::Zero();
  Vec2 wanted_mps = Vec2::Zero();  ///< velocity after this period, need not be reachable
  double speed_max_mps = 3.0;
  bool may_enter_own_area = false;
  bool must_stand = false;  ///< brakes and then stands, whoever comes: halted, or nobody plans for it
};

class SafetySearch {
 public:
  /// The velocities after this period, one per robot of `team` and reachable within limits. Deterministic; ties go to
  /// the sample generated first. The promises only hold while all robots of the team are here and period_s > 0 stays
  /// the same.
  void choose(std::span<const SafetyRobot> team, std::span<const Opponent> opponents, const Surroundings& around,
              const RobotLimits& limits, const SafetyParams& params, double period_s, std::vector<Vec2>& chosen_mps);

 private:
  /// How much of what is wanted of a motion holds, by rank. All but `none` keep clear of the team's promises and of
  /// what stands. `dodge`: clear of where opponents are expected, with half the margins, but not of their braking.
  /// `way_through`: the same with all margins. `opponents_brake`: clear of their braking. From `opponents_expected` on:
  /// of both. `ahead`: of opponents that keep their velocities and of where team-mates are expected too.
  enum class Safety { none, team, dodge, way_through, opponents_brake, opponents_expected, ahead };

  void sample(const SafetyRobot& robot);
  Vec2 choose_for(std::size_t robot);
  Vec2 brake(std::size_t robot);
  Vec2 stop(std::size_t robot);
  /// Exact where it is at least `best`; else less than that.
  Safety safety_of(std::size_t robot, const Vec2& next_mps, const Motion& motion, Safety best) const;
  bool is_clear_of_team(std::size_t robot, const Motion& motion, const std::vector<Motion>& others) const;
  bool is_clear_of_shapes(std::size_t robot, const Motion& motion) const;
  bool is_clear_of_expected(std::size_t robot, const Vec2& next_mps, const Motion& motion, Care care) const;
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
  Motion promised_candidate_;
  OpponentModels opponents_;
  std::vector<std::pair<double, Vec2>> samples_;  ///< squared distance from the wanted velocity, velocity
};

}  // namespace regista
