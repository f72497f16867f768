#include "modules/ssl/command_relay.h"

namespace regista {

std::vector<RobotCommand> CommandRelay::beside(const std::vector<RobotCommand>& commands, Time now) {
  for (const RobotCommand& command : commands) driven_.erase(command.robot);
  std::vector<RobotCommand> stops = idle(now);
  for (const RobotCommand& command : commands) driven_[command.robot] = now;
  return stops;
}

std::vector<RobotCommand> CommandRelay::idle(Time now) {
  sent_ = now;
  std::erase_if(driven_, [&](const auto& entry) { return now - entry.second > kStopFor; });
  std::vector<RobotCommand> stops;
  for (const auto& [robot, last_driven] : driven_) {
    RobotCommand stop;
    stop.robot = robot;
    stops.push_back(stop);
  }
  return stops;
}

}  // namespace regista
