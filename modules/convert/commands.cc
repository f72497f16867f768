#include "modules/convert/commands.h"

#include <algorithm>

#include "modules/convert/common.h"

namespace regista {
namespace {

robot_command_t to_message(const RobotCommand& command) {
  robot_command_t message{};
  message.robot = number_code(command.robot);
  message.forward_mps = command.velocity.forward_mps;
  message.left_mps = command.velocity.left_mps;
  message.angular_radps = command.velocity.angular_radps;
  std::copy(command.wheel_speeds_radps.begin(), command.wheel_speeds_radps.end(), message.wheel_speeds_radps);
  message.kick_speed_mps = command.kick_speed_mps;
  message.dribbler_radps = command.dribbler_radps;
  return message;
}

RobotCommand from_message(const robot_command_t& message) {
  RobotCommand command;
  command.robot = number_from(message.robot);
  const Vec2 velocity = velocity_from(message.forward_mps, message.left_mps);
  command.velocity = {velocity.x(), velocity.y(), turn_from(message.angular_radps)};
  for (std::size_t i = 0; i < command.wheel_speeds_radps.size(); ++i) {
    command.wheel_speeds_radps[i] = finite(message.wheel_speeds_radps[i], "wheel_speeds_radps");
  }
  command.kick_speed_mps = at_least(message.kick_speed_mps, 0.0, "kick_speed_mps");
  command.dribbler_radps = at_least(message.dribbler_radps, 0.0, "dribbler_radps");
  return command;
}

}  // namespace

commands_t MessageOf<TeamCommands>::to_message(const TeamCommands& commands) {
  commands_t message{};
  message.stamp_us = to_us(commands.captured);
  message.team = team_code(commands.team);
  message.sequence = sequence_code(commands.sequence);
  message.world_sequence = sequence_code(commands.world_sequence);
  message.command_count = count_of(commands.commands);
  for (const RobotCommand& command : commands.commands) message.commands.push_back(regista::to_message(command));
  return message;
}

TeamCommands MessageOf<TeamCommands>::from_message(const commands_t& message) {
  TeamCommands commands;
  commands.captured = time_from(message.stamp_us);
  commands.team = team_from(message.team);
  commands.sequence = sequence_from(message.sequence);
  commands.world_sequence = sequence_from(message.world_sequence);
  for (const robot_command_t& command : message.commands) commands.commands.push_back(regista::from_message(command));
  require(strictly_sorted(commands.commands, [](const RobotCommand& command) { return command.robot; }),
          "commands are not sorted by robot, or one robot comes twice");
  return commands;
}

template std::vector<std::uint8_t> encode(const TeamCommands&);
template TeamCommands decode(std::span<const std::uint8_t>);

}  // namespace regista
