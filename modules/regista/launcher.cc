#include "modules/regista/launcher.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <thread>

#include "modules/regista/command.h"

namespace regista {
namespace {

constexpr Duration kStatusFresh = std::chrono::seconds(3);  // modules report once a second
constexpr Duration kStopWait = std::chrono::seconds(2);
constexpr Duration kStopPoll = std::chrono::milliseconds(10);
constexpr std::size_t kLinesAtOnce = 20;  // of one module; one that talks without end must not drown the others

}  // namespace

Launcher::Launcher(Bus& bus, const std::vector<ChildSpec>& specs, const std::string& folder, Display& display)
    : bus_(bus), folder_(folder), display_(display), listener_(bus, channels::statuses(), [this](ModuleStatus status) {
        const std::string module = status.module;
        reports_[module] = {std::move(status), bus_.now()};
      }) {
  for (const ChildSpec& spec : specs) {
    const std::string path = folder_ + "/" + spec.program;
    if (access(path.c_str(), X_OK) != 0) throw CommandError("no program " + path + ": build it, or leave it out");
  }
  for (const ChildSpec& spec : specs) modules_.push_back({spec, {}, nullptr, {}, {}, false, {}});
  for (Watched& module : modules_) start(module);
}

void Launcher::start(Watched& module) {
  module.process = std::make_unique<ModuleProcess>(folder_ + "/" + module.spec.program, module.spec.arguments);
  module.started = bus_.now();
  module.restart_at.reset();
  module.policy.started(module.started);
  display_.event(fmt::format("{} started, pid {}", module.spec.name, module.process->pid()));
}

void Launcher::relay_output(Watched& module) {
  const std::vector<std::string> lines = module.process->read_lines();
  if (lines.empty()) return;
  const std::size_t shown = std::min(lines.size(), kLinesAtOnce);
  for (std::size_t i = 0; i < shown; ++i) display_.event(module.spec.name + ": " + lines[i]);
  if (shown < lines.size()) display_.event(fmt::format("{}: … {} more lines", module.spec.name, lines.size() - shown));
  module.last_line = lines.back();
}

void Launcher::bury(Watched& module, const ProcessEnd& end) {
  module.process.reset();
  module.left = end.in_order && module.spec.may_end;
  if (module.left) {
    display_.event(module.spec.name + " was closed");
    return;
  }
  module.restart_at = module.policy.died(bus_.now());
  display_.event(
      fmt::format("{} {}, {}", module.spec.name, end.text, module.restart_at ? "starting it again" : "given up"));
  if (module.restart_at) return;
  display_.event(fmt::format("{} died quickly {} times in a row; its last words: {}", module.spec.name,
                             RestartPolicy::kGiveUpAfter, module.last_line));
}

void Launcher::watch(Watched& module) {
  if (module.process) {
    const std::optional<ProcessEnd> end = module.process->end();
    relay_output(module);
    if (end) bury(module, *end);
  }
  if (module.restart_at && bus_.now() >= *module.restart_at) start(module);
}

void Launcher::step(Duration wait) {
  if (bus_.handle(wait)) {
    while (bus_.handle(Duration::zero())) {
    }
  }
  for (Watched& module : modules_) watch(module);
  display_.update(bus_.now(), rows());
}

bool Launcher::all_ended() {
  return std::all_of(modules_.begin(), modules_.end(),
                     [](Watched& module) { return !module.process || module.process->end().has_value(); });
}

void Launcher::stop() {
  for (const Watched& module : modules_) {
    if (module.process) module.process->send(SIGTERM);
  }
  // A steady count instead of the bus's clock, for nothing but waiting is done here.
  for (Duration waited{}; !all_ended() && waited < kStopWait; waited += kStopPoll) {
    for (Watched& module : modules_) {
      if (module.process) relay_output(module);  // a full pipe must not keep it from ending
    }
    std::this_thread::sleep_for(kStopPoll);
  }
  for (Watched& module : modules_) {
    if (!module.process) continue;
    relay_output(module);
    if (!module.process->end()) display_.event(module.spec.name + " does not end, killed");
    module.process.reset();
  }
}

std::size_t Launcher::given_up() const {
  return static_cast<std::size_t>(
      std::count_if(modules_.begin(), modules_.end(), [](const Watched& module) { return module.policy.given_up(); }));
}

ModuleRow Launcher::row_of(const Watched& module) const {
  const char* state = module.left ? "closed" : module.policy.given_up() ? "given up" : "restarting";
  ModuleRow row{module.spec.name, {}, state, {}, {}, module.last_line};
  if (!module.process) return row;
  const Time now = bus_.now();
  row.pid = module.process->pid();
  row.uptime = now - module.started;
  row.state = row.uptime < kStatusFresh ? "starting" : "silent";
  row.note.clear();
  const auto report = reports_.find(module.spec.name);
  if (report == reports_.end() || now - report->second.arrived > kStatusFresh) return row;
  const ModuleStatus& status = report->second.status;
  if (status.pid != *row.pid) {
    // The report may be the last of its predecessor, who is dead by now.
    if (report->second.arrived < module.started) return row;
    row.note = fmt::format("runs twice on this bus: also as pid {} on {}, stop one", status.pid, status.host);
    return row;
  }
  row.state = "running";
  row.status = status;
  row.note = status.note;
  return row;
}

std::vector<ModuleRow> Launcher::rows() const {
  std::vector<ModuleRow> rows;
  for (const Watched& module : modules_) rows.push_back(row_of(module));
  for (const auto& [name, report] : reports_) {
    const bool ours = std::any_of(modules_.begin(), modules_.end(),
                                  [&name = name](const Watched& module) { return module.spec.name == name; });
    if (ours || bus_.now() - report.arrived > kStatusFresh) continue;
    rows.push_back({name, report.status.pid, "elsewhere", report.status.uptime, report.status,
                    report.status.note.empty() ? "on " + report.status.host : report.status.note});
  }
  return rows;
}

}  // namespace regista
