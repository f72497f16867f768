// What a robot is told, and a team's commands together: the output of control.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "world_model/types/body_velocity.h"
#include "world_model/types/robot_id.h"

namespace regista {

struct RobotCommand {
  std::uint16_t robot = 0;  ///< number within the team
  BodyVelocity velocity;
  std::array<double, 4> wheel_speeds_radps{};  ///< front left, back left, back right, front right
  double kick_speed_mps = 0.0;                 ///< 0: no kick
  double dribbler_radps = 0.0;                 ///< >= 0
  bool operator==(const RobotCommand&) const = default;
};

struct TeamCommands {
  Time captured{};  ///< capture time of the world they are made from
  Team team = Team::yellow;
  std::uint64_t sequence = 0;          ///< counts up with every message
  std::uint64_t world_sequence = 0;    ///< WorldState::sequence they are made from
  std::vector<RobotCommand> commands;  ///< sorted by robot, each once; a robot without command brakes
  bool operator==(const TeamCommands&) const = default;
};

}  // namespace regista
