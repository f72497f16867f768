// The radio between team and robots: commands act after a delay, some are lost, a robot knows when it hears nothing.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "control/velocity_command.h"
#include "sim/random.h"
#include "sim/sim_params.h"

namespace regista {

struct HeardCommand {
  BodyVelocity velocity;
  double kick_speed_mps = 0.0;
  bool operator==(const HeardCommand&) const = default;
};

class CommandLink {
 public:
  /// `robots` sorted; a robot's index in it is how the other functions name it.
  CommandLink(std::vector<RobotId> robots, const RadioParams& params, std::uint64_t seed);

  /// Takes a team's commands; they act a fixed latency after `arrived`. Those for robots that are not there are left
  /// out. Throws std::invalid_argument with robot and
  /// value, taking none of them, when a velocity or kick is not finite or a kick is negative.
  void receive(const TeamCommands& commands, Time arrived);

  /// Lets all commands act that are due at `now`; the newest of each robot wins.
  void update(Time now);

  /// What the robot does at `now`; nullptr when nothing has acted within the timeout and it must brake.
  const HeardCommand* heard(std::size_t robot, Time now) const;

 private:
  struct Underway {
    Time acts_at;
    std::size_t robot;
    HeardCommand command;
  };
  struct Hearing {
    bool any = false;
    Time since{};
    HeardCommand command;
  };

  std::vector<RobotId> robots_;
  RadioParams params_;
  Random random_;
  std::deque<Underway> underway_;  // by acts_at
  std::vector<Hearing> hearing_;   // per robot
};

}  // namespace regista
