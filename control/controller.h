// One team's controller: world state and plans in, velocity commands out. Each robot follows its path and turns to its
// target's heading; the team's velocities are made safe together; then each is limited against the last command and
// converted to the body and its wheels.
#pragma once

#include <cstdint>
#include <map>
#include <span>

#include "control/avoidance.h"
#include "control/control_params.h"
#include "control/present_opponents.h"
#include "control/team_wheels.h"
#include "control/velocity_command.h"
#include "planning/plan.h"
#include "world_model/types/world_state.h"

namespace regista {

class Controller {
 public:
  /// Throws std::invalid_argument when the wheels of the params make no robot or there is no such safety mode.
  Controller(Team team, const ControlParams& params);

  /// From the next command on; what was commanded stays remembered, so nothing jumps.
  void set_params(const ControlParams& params);

  /// Commands for every robot of the team in the world state. `plans`: at most one per robot, stale ones left out by
  /// the caller; plans of other robots are ignored. `around`: what does not move. A robot without plan, or with one
  /// that is invalid or has no path, brakes at its limit, and so does one that vision has lost for unseen_deadline_s.
  /// dt_s > 0 is the time since the last call.
  ///
  /// Between two calls a command changes by no more than the limits allow in dt_s, whatever happens to plans; only a
  /// robot whose estimated motion is implausibly far from its last command is picked up where it is, and a wheel limit
  /// below the body's limits cuts at once. Throws std::invalid_argument, with nothing remembered, on numbers that are
  /// not finite, two plans for a robot, or dt_s <= 0.
  TeamCommands update(const WorldState& world, std::span<const RobotPlan> plans, double dt_s,
                      const Surroundings& around = {});

  /// The commands while no fresh world state comes: every robot that was commanded last brakes straight ahead, its
  /// heading carried on from the last command. last_world gives stamp and sequence, nullptr where there never was one.
  TeamCommands brake(const WorldState* last_world, double dt_s);

 private:
  /// What a robot was told last, field frame.
  struct Told {
    Twist twist;
    double heading_rad = 0.0;  ///< where it looked when the command began to act
  };

  /// What one robot wants, and what is known of it.
  struct Intent {
    Told told;
    SafetyRobot robot;
    double rate_radps = 0.0;
    double arrival_s = 0.0;
  };

  Intent intent_of(const RobotState& robot, const RobotPlan* plan, double dt_s) const;
  /// Takes away wanted speed towards opponents (careful_approach.h).
  void be_careful(std::span<SafetyRobot> robots, std::span<const Opponent> opponents) const;
  RobotCommand command(std::uint16_t robot, Told& told, const Twist& wanted, double dt_s) const;
  TeamCommands begin(const WorldState* world);

  Team team_;
  ControlParams params_;
  TeamWheels wheels_;
  std::uint64_t sequence_ = 0;
  PresentOpponents opponents_;
  RoughPlay rough_play_;
  Avoidance avoidance_;
  std::map<std::uint16_t, Told> last_;  ///< by robot number
};

}  // namespace regista
