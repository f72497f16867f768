// When a team's commands go out and what is sent when none come: silence means stop, and a port is never left quiet.
#pragma once

#include <map>
#include <vector>

#include "control/velocity_command.h"

namespace regista {

/// Pure: the clock is an argument, sending is the caller's. Every call that returns a list counts as sent at `now`.
class CommandRelay {
 public:
  /// The first list is due at once.
  explicit CommandRelay(Time start) : sent_(start - kKeepAlive) {}

  /// Fresh commands go out now: the stops to send with them, for robots that were driven lately and have none.
  std::vector<RobotCommand> beside(const std::vector<RobotCommand>& commands, Time now);

  /// When to send although nothing has come.
  Time due() const { return sent_ + (driven_.empty() ? kKeepAlive : kSilence); }

  /// To send when due: a stop for each robot driven lately; empty when there is none, sent all the same.
  std::vector<RobotCommand> idle(Time now);

  /// After so long without fresh commands robots are stopped, and told so again at this interval: the time after which
  /// simulators stop a robot by themselves.
  static constexpr Duration kSilence = std::chrono::milliseconds(100);

  /// A stop is repeated for so long, so that lost datagrams do not matter. Later the other side's own time-out
  /// protects, and another program may use the port.
  static constexpr Duration kStopFor = std::chrono::seconds(2);

  /// One simulator stops a colour when the other colour's port hears nothing for 1 s: more than twice as often as that.
  static constexpr Duration kKeepAlive = std::chrono::milliseconds(400);

 private:
  Time sent_;
  std::map<std::uint16_t, Time> driven_;  ///< robots with a command within kStopFor, and when the last one was sent
};

}  // namespace regista
