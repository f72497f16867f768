// What the tests of the whole system start, and how they listen to it.
#pragma once

#include <algorithm>
#include <map>

#include "modules/bus/mailbox.h"
#include "modules/convert/commands.h"
#include "modules/convert/planning.h"
#include "modules/convert/service.h"
#include "modules/process/real_clock.h"
#include "tests/support/program.h"

namespace regista {

/// The modules that `regista up` starts for a simulated field.
inline const std::vector<std::string> kLoop{"sim",       "world-model",  "task",        "planner.Y",
                                            "planner.B", "controller.Y", "controller.B"};

/// The command that starts them.
inline std::vector<std::string> up(const std::string& url) {
  return {executable("regista"), "up", "crossing", "--lcm-url", url};
}

/// Listens to a bus; the newest of everything, on demand.
class Ear {
 public:
  explicit Ear(const std::string& url) : bus_(url, real_clock()) {}

  /// Takes what has come in, then asks.
  bool eventually(const std::function<bool()>& holds) {
    return regista::eventually([&] {
      while (bus_.handle(Duration::zero())) {
      }
      return holds();
    });
  }

  bool all_report(const std::vector<std::string>& modules) const {
    return std::all_of(modules.begin(), modules.end(), [&](const std::string& name) { return pids_.count(name) > 0; });
  }
  int pid(const std::string& module) const { return pids_.at(module); }
  const RobotPlan* plan() const { return plan_.newest(); }
  std::int64_t commands() const { return commands_.reception().received; }
  const Targets* targets() const { return targets_.newest(); }

 private:
  Bus bus_;
  std::map<std::string, int> pids_;
  Listener<ModuleStatus> statuses_{bus_, channels::statuses(),
                                   [this](const ModuleStatus& status) { pids_[status.module] = status.pid; }};
  Mailbox<RobotPlan> plan_{bus_, channels::plans(Team::yellow)};
  Mailbox<TeamCommands> commands_{bus_, channels::commands(Team::blue)};
  Mailbox<Targets> targets_{bus_, channels::targets(Team::yellow)};
};

}  // namespace regista
