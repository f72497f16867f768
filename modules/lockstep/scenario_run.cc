#include "modules/lockstep/scenario_run.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "logs/log_writer.h"
#include "modules/lockstep/whole_loop.h"
#include "modules/setup/module_setup.h"

namespace regista {
namespace {

constexpr Duration kProgressEvery = std::chrono::seconds(1);

/// Writes every reproducible message of the loop's bus to a log.
class Recorder {
 public:
  Recorder(LockStep& loop, const std::string& file) : writer_(file) {
    tap_ =
        loop.bus().subscribe_raw(".*", [this, &loop](const std::string& channel, std::span<const std::uint8_t> bytes) {
          if (!channels::is_measured(channel)) writer_.write(loop.now(), channel, bytes);
        });
  }
  void close() { writer_.close(); }

 private:
  LogWriter writer_;
  std::unique_ptr<Bus::Subscription> tap_;
};

/// Collects what the planners measured.
class PlanningTimes {
 public:
  explicit PlanningTimes(Bus& bus)
      : listener_(bus, {"TIMING\\.planner\\..*"}, [this](const Timing& timing) {
          team_ns_.push_back(timing.tick_ns);
          for (const RobotTime& robot : timing.robots) robot_ns_.push_back(robot.duration_ns);
        }) {}
  Percentiles robot() const { return percentiles(robot_ns_); }
  Percentiles team() const { return percentiles(team_ns_); }

 private:
  std::vector<std::int64_t> robot_ns_;
  std::vector<std::int64_t> team_ns_;
  Listener<Timing> listener_;
};

/// Shows the validators every frame: the truth, the score, and what the teams were told last.
class Judge {
 public:
  Judge(Bus& bus, const WholeLoop& modules, std::vector<Validator> validators)
      : modules_(modules),
        validation_(std::move(validators)),
        yellow_(bus, channels::commands(Team::yellow)),
        blue_(bus, channels::commands(Team::blue)) {}

  void observe() {
    with_observation([this](const Observation& observation) { validation_.observe(observation); });
  }
  std::vector<Violation> finish() {
    with_observation([this](const Observation& observation) { validation_.finish(observation); });
    return validation_.violations();
  }

 private:
  void with_observation(const std::function<void(const Observation&)>& use) {
    const WorldState truth = modules_.sim->simulator().truth();
    std::vector<TeamCommands> commands;
    for (const auto* newest : {yellow_.newest(), blue_.newest()}) {
      if (newest != nullptr) commands.push_back(*newest);
    }
    use({truth, modules_.sim->simulator().contact_counts(), modules_.task->reached(Team::yellow),
         modules_.task->reached(Team::blue), commands});
  }

  WholeLoop modules_;
  Validation validation_;
  Mailbox<TeamCommands> yellow_;
  Mailbox<TeamCommands> blue_;
};

void note_score(RunSummary& summary, const WholeLoop& modules) {
  summary.reached_yellow = modules.task->reached(Team::yellow);
  summary.reached_blue = modules.task->reached(Team::blue);
  summary.contacts = modules.sim->simulator().contact_counts();
}

}  // namespace

RunSummary run_scenario(const Config& config, const RunOptions& options, const Stopwatch& stopwatch) {
  RunSummary summary;
  summary.scenario = config.scenario();
  LockStep loop{Time{}};
  PlanningTimes planning(loop.bus());
  const WholeLoop modules = add_whole_loop(loop, config, stopwatch);
  const auto side_changes_of = [&](Team team) {
    return std::make_unique<SideChanges>(loop.bus(), team, planner_params_of(config, team).planning);
  };
  const auto yellow_side_changes = side_changes_of(Team::yellow);
  const auto blue_side_changes = side_changes_of(Team::blue);
  // After the modules: a configuration that they refuse must not cost an older log.
  std::optional<Recorder> recorder;
  if (!options.log_file.empty()) recorder.emplace(loop, options.log_file);
  Judge judge(loop.bus(), modules, validators_of(summary.scenario, modules.sim->simulator().params().limits));

  const Time end = Time{} + from_seconds(summary.scenario.duration_s);
  const Duration period = from_seconds(1.0 / modules.sim->simulator().params().vision.rate_hz);
  std::vector<std::int64_t> frames_ns;
  const std::int64_t begin_ns = stopwatch();
  Time next_progress = Time{} + kProgressEvery;
  while (loop.now() < end && !(options.stopped && options.stopped())) {
    const std::int64_t frame_begin_ns = stopwatch();
    loop.run_until(std::min(end, loop.now() + period));
    frames_ns.push_back(stopwatch() - frame_begin_ns);
    judge.observe();
    if (loop.now() < next_progress) continue;
    next_progress += kProgressEvery;
    note_score(summary, modules);
    if (options.on_progress) options.on_progress(to_seconds(loop.now() - Time{}), summary);
  }
  summary.wall_s = static_cast<double>(stopwatch() - begin_ns) * 1e-9;
  summary.simulated_s = to_seconds(loop.now() - Time{});
  note_score(summary, modules);
  summary.side_changes_yellow = yellow_side_changes->rate();
  summary.side_changes_blue = blue_side_changes->rate();
  summary.violations = judge.finish();
  summary.robot_planning = planning.robot();
  summary.team_planning = planning.team();
  summary.frame = percentiles(std::move(frames_ns));
  if (recorder) recorder->close();
  return summary;
}

}  // namespace regista
