#include "sim/command_link.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace regista {
namespace {

void check(const RobotCommand& command, RobotId id) {
  const auto need = [id](bool good, const char* what, double value) {
    if (!good)
      throw std::invalid_argument("command for " + to_string(id) + ": " + what + " is " + std::to_string(value));
  };
  const BodyVelocity& v = command.velocity;
  need(std::isfinite(v.forward_mps), "forward_mps", v.forward_mps);
  need(std::isfinite(v.left_mps), "left_mps", v.left_mps);
  need(std::isfinite(v.angular_radps), "angular_radps", v.angular_radps);
  need(std::isfinite(command.kick_speed_mps) && command.kick_speed_mps >= 0.0, "kick_speed_mps",
       command.kick_speed_mps);
}

}  // namespace

CommandLink::CommandLink(std::vector<RobotId> robots, const RadioParams& params, std::uint64_t seed)
    : robots_(std::move(robots)), params_(params), random_(seed), hearing_(robots_.size()) {}

void CommandLink::receive(const TeamCommands& commands, Time arrived) {
  for (const RobotCommand& command : commands.commands) check(command, {commands.team, command.robot});
  const Time acts_at = arrived + from_seconds(params_.latency_s);
  const auto later = std::upper_bound(underway_.begin(), underway_.end(), acts_at,
                                      [](Time time, const Underway& other) { return time < other.acts_at; });
  std::vector<Underway> added;
  for (const RobotCommand& command : commands.commands) {
    const bool lost = random_.chance(params_.loss);
    const RobotId id{commands.team, command.robot};
    const auto robot = std::lower_bound(robots_.begin(), robots_.end(), id);
    if (lost || robot == robots_.end() || *robot != id) continue;
    const auto index = static_cast<std::size_t>(robot - robots_.begin());
    added.push_back({acts_at, index, {command.velocity, command.kick_speed_mps}});
  }
  underway_.insert(later, added.begin(), added.end());
}

void CommandLink::update(Time now) {
  for (; !underway_.empty() && underway_.front().acts_at <= now; underway_.pop_front()) {
    const Underway& due = underway_.front();
    Hearing& hearing = hearing_[due.robot];
    if (!hearing.any || due.acts_at >= hearing.since) hearing = {true, due.acts_at, due.command};
  }
}

const HeardCommand* CommandLink::heard(std::size_t robot, Time now) const {
  const Hearing& hearing = hearing_[robot];
  return hearing.any && now - hearing.since < from_seconds(params_.timeout_s) ? &hearing.command : nullptr;
}

}  // namespace regista
