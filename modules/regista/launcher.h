// Runs a set of modules as child processes: starts them, listens to their STATUS, restarts what dies, with what was
// chosen at run time, ends them all.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "modules/bus/mailbox.h"
#include "modules/convert/service.h"
#include "modules/regista/display.h"
#include "modules/regista/module_process.h"
#include "modules/regista/module_set.h"
#include "modules/regista/restart_policy.h"
#include "modules/regista/runtime_choices.h"
#include "modules/regista/status_reports.h"

namespace regista {

class Launcher {
 public:
  /// Starts all of them. The programs are in `folder`. Throws CommandError naming a program that is not there.
  Launcher(Bus& bus, const std::vector<ChildSpec>& specs, const std::string& folder, Display& display);

  /// Listens, watches, restarts and shows for about that long.
  void step(Duration wait);

  /// SIGTERM to all, SIGKILL after two seconds to those that have not ended. Nothing is left when it returns.
  void stop();

  /// Modules that died too often to be started again.
  std::size_t given_up() const;
  std::size_t size() const { return modules_.size(); }

 private:
  struct Watched {
    ChildSpec spec;
    RestartPolicy policy;
    std::unique_ptr<ModuleProcess> process;  ///< nullptr while it is dead
    Time started{};
    std::optional<Time> restart_at;
    bool left = false;      ///< it ended in order and may
    std::string last_line;  ///< it wrote
  };
  void start(Watched& module);
  void watch(Watched& module);
  void bury(Watched& module, const ProcessEnd& end);
  void relay_output(Watched& module);
  void tell_twins();
  bool all_ended();
  std::vector<ModuleRow> rows() const;
  ModuleRow row_of(const Watched& module) const;
  ModuleRow row_elsewhere(const StatusReport& report) const;

  Bus& bus_;
  std::string folder_;
  Display& display_;
  std::vector<Watched> modules_;
  std::string host_;
  std::set<int> own_pids_;            ///< of all processes started so far
  StatusReports reports_;             ///< of all modules on the bus
  std::set<std::string> twins_told_;  ///< modules that run more than once, as said already
  RuntimeChoices choices_;
  Listener<ModuleStatus> statuses_;
  Listener<Request> requests_;
  Listener<Reply> replies_;
};

}  // namespace regista
