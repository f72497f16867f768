#include "modules/regista/launcher.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <thread>
#include <utility>

#include "modules/regista/command.h"

namespace regista {
namespace {

constexpr int kMostPerStep = 10'000;  // messages; one that talks without end must not keep it from watching
constexpr Duration kStopWait = std::chrono::seconds(2);
constexpr Duration kStopPoll = std::chrono::milliseconds(10);
constexpr std::size_t kLinesAtOnce = 20;  // of one module; one that talks without end must not drown the others

/// As modules name it in STATUS.
std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "?";
}

std::vector<std::string> names_of(const std::vector<ChildSpec>& specs) {
  std::vector<std::string> names;
  names.reserve(specs.size());
  for (const ChildSpec& spec : specs) names.push_back(spec.name);
  return names;
}

}  // namespace

Launcher::Launcher(Bus& bus, const std::vector<ChildSpec>& specs, const std::string& folder, Display& display)
    : bus_(bus),
      folder_(folder),
      display_(display),
      host_(host_name()),
      choices_(names_of(specs)),
      statuses_(bus, channels::statuses(),
                [this](ModuleStatus status) { reports_.take(std::move(status), bus_.now()); }),
      requests_(bus, channels::request(), [this](const Request& request) { choices_.take(request); }),
      replies_(bus, channels::reply(), [this](const Reply& reply) { choices_.take(reply); }) {
  for (const ChildSpec& spec : specs) {
    const std::string path = folder_ + "/" + spec.program;
    if (access(path.c_str(), X_OK) != 0) throw CommandError("no program " + path + ": build it, or leave it out");
  }
  for (const ChildSpec& spec : specs) modules_.push_back({spec, {}, nullptr, {}, {}, false, {}});
  for (Watched& module : modules_) start(module);
}

void Launcher::start(Watched& module) {
  std::vector<std::string> arguments = module.spec.arguments;
  std::string chosen;
  for (const std::string& setting : choices_.settings_of(module.spec.name)) {
    arguments.insert(arguments.end(), {"--set", setting});
    chosen += (chosen.empty() ? " with " : ", ") + setting;
  }
  const char* what = module.started == Time{} ? "started" : "restarted";
  module.process = std::make_unique<ModuleProcess>(folder_ + "/" + module.spec.program, arguments);
  own_pids_.insert(module.process->pid());
  module.started = bus_.now();
  module.restart_at.reset();
  module.policy.started(module.started);
  display_.event(fmt::format("{} {}{}, pid {}", module.spec.name, what, chosen, module.process->pid()));
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
  bool more = bus_.handle(wait);
  for (int taken = 1; more && taken < kMostPerStep; ++taken) more = bus_.handle(Duration::zero());
  reports_.forget_old(bus_.now());
  tell_twins();
  for (Watched& module : modules_) watch(module);
  display_.update(bus_.now(), rows());
}

void Launcher::tell_twins() {
  std::set<std::string> twins;
  for (const StatusReport& report : reports_.all()) {
    const std::string text = twins_text(reports_.twins_of(report));
    if (text.empty() || !twins.insert(report.status.module).second || twins_told_.count(report.status.module) > 0) {
      continue;
    }
    display_.event(
        fmt::format("{}, pid {} on {}, {}", report.status.module, report.status.pid, report.status.host, text));
  }
  twins_told_ = std::move(twins);
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
  row.state = row.uptime < StatusReports::kFresh ? "starting" : "silent";
  row.note.clear();
  const StatusReport* report = reports_.of(module.spec.name, host_, *row.pid);
  if (report == nullptr) return row;
  row.state = "running";
  row.status = report->status;
  const std::string twins = twins_text(reports_.twins_of(*report));
  row.note = twins.empty() ? report->status.note : twins;
  return row;
}

ModuleRow Launcher::row_elsewhere(const StatusReport& report) const {
  const ModuleStatus& status = report.status;
  std::string note = twins_text(reports_.twins_of(report));
  if (note.empty()) note = status.note.empty() ? "on " + status.host : status.note;
  return {status.module, status.pid, "elsewhere", status.uptime, status, note};
}

std::vector<ModuleRow> Launcher::rows() const {
  std::vector<ModuleRow> rows;
  for (const Watched& module : modules_) rows.push_back(row_of(module));
  for (const StatusReport& report : reports_.all()) {
    // The own ones have their rows, and the reports of their dead predecessors are of no interest.
    const bool ours = report.status.host == host_ && own_pids_.count(report.status.pid) > 0;
    if (!ours) rows.push_back(row_elsewhere(report));
  }
  return rows;
}

}  // namespace regista
