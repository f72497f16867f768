// Dynamic safety search for a team (after Bruce & Veloso, "Safe multirobot navigation within dynamics constraints",
// Proc. IEEE 94(7), 2006): every robot gets the reachable velocity nearest to the wanted one after which it can still
// brake to a stand without touching anything.
//
// Why team-mates never touch while robots do as they are told: every robot has promised how it goes on, "hold this
// velocity for so long, then brake", and those promises are free of contact. Robots choose one after another; a choice
// is a new promise, "change the velocity for one period, hold it, brake", checked in continuous time against the
// newest promise of everybody else. Keeping the old promise is always left, for everybody's newer one was checked
// against it. Braking takes whole periods, so at the next tick the rest of each promise is exactly what is promised
// then, and the argument starts anew.
#pragma once

#include <span>
#include <vector>

#include "control/safety/motion.h"
#include "control/safety/safety_params.h"
#include "control/safety/separation.h"
#include "control/safety/surroundings.h"

namespace regista {

/// One of ours, as its commands move it: the velocity it has been told, and where that begins to act.
struct SafetyRobot {
  Vec2 position_m = Vec2::Zero();
  Vec2 velocity_mps = Vec2::Zero();
  Vec2 wanted_mps = Vec2::Zero();  ///< velocity after this period, need not be reachable
  double hold_s = 0.0;  ///< promised to go on at this velocity for so long before it brakes
  double speed_max_mps = 3.0;
  bool may_enter_own_area = false;
};

/// One whose mind is not known.
struct Opponent {
  Vec2 position_m = Vec2::Zero();
  Vec2 velocity_mps = Vec2::Zero();
  Vec2 acceleration_mps2 = Vec2::Zero();  ///< estimated
};

/// What a robot does in this period, and what it promises for the time after.
struct SafeChoice {
  Vec2 velocity_mps = Vec2::Zero();  ///< at the end of the period
  double hold_s = 0.0;               ///< from then on, before it brakes
};

class SafetySearch {
 public:
  /// One choice per robot of `team`, reachable within limits. Deterministic; ties go to the sample generated first. The
  /// promises only hold while all robots of the team are here and period_s > 0 stays the same.
  void choose(std::span<const SafetyRobot> team, std::span<const Opponent> opponents, const Surroundings& around,
              const RobotLimits& limits, const SafetyParams& params, double period_s, std::vector<SafeChoice>& chosen);

 private:
  /// How much of what is wanted of a motion holds; each includes those before.
  enum class Safety { none, team, opponents_brake, opponents_predicted };
  struct OpponentModel {
    Motion braking;
    Motion predicted;
    double braking_gap_m = 0.0;
    double gap_m = 0.0;
  };

  void predict(std::span<const Opponent> opponents);
  void sample(const SafetyRobot& robot);
  SafeChoice choose_for(std::size_t robot);
  SafeChoice keep_promise(std::size_t robot) const;
  Safety safety_of(std::size_t robot, const Vec2& next_mps, const Motion& motion) const;
  bool is_clear_of_team(std::size_t robot, const Motion& motion) const;
  bool is_clear_of_shapes(std::size_t robot, const Motion& motion) const;
  bool is_clear_of_braking_opponents(std::size_t robot, const Motion& motion) const;
  bool is_clear_of_predicted(std::size_t robot, const Vec2& next_mps, const Motion& motion) const;
  Motion motion_of(std::size_t robot, const SafeChoice& choice) const;

  // Of the call that is being answered.
  std::span<const SafetyRobot> team_;
  const Surroundings* around_ = nullptr;
  const RobotLimits* limits_ = nullptr;
  const SafetyParams* params_ = nullptr;
  double period_s_ = 0.0;
  std::vector<Motion> promised_;  ///< by robot
  std::vector<OpponentModel> opponents_;
  std::vector<std::pair<double, Vec2>> samples_;  ///< squared distance from the wanted velocity, velocity
};

}  // namespace regista
