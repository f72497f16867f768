// One yellow robot on the field, and how it is told what to do, for the tests of the simulator.
#pragma once

#include "sim/simulator.h"

namespace regista::test {

inline constexpr RobotId kYellow{Team::yellow, 3};
inline constexpr RobotId kBlue{Team::blue, 1};

inline SimSetup one_robot(const SimParams& params) {
  SimSetup setup;
  setup.params = params;
  setup.robots = {{kYellow, {{-3.0, 1.0}, 0.0}}};
  return setup;
}

inline TeamCommands tell(RobotId id, const BodyVelocity& velocity, double kick_mps = 0.0) {
  RobotCommand command;
  command.robot = id.number;
  command.velocity = velocity;
  command.kick_speed_mps = kick_mps;
  TeamCommands commands;
  commands.team = id.team;
  commands.commands = {command};
  return commands;
}

}  // namespace regista::test
