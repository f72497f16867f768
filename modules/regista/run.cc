#include "modules/regista/run.h"

#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "modules/lockstep/scenario_run.h"
#include "modules/process/module_program.h"

namespace regista {
namespace {

struct Options {
  std::string scenario = "crossing";
  std::vector<std::string> settings;
  std::string out = ".";
  bool no_log = false;
  bool no_picture = false;
};

void show_progress(double simulated_s, const RunSummary& so_far) {
  constexpr int kEvery_s = 10;
  const bool terminal = isatty(STDOUT_FILENO) == 1;
  if (!terminal && std::lround(simulated_s) % kEvery_s != 0) return;
  std::printf("%s%5.0f of %.0f s simulated, targets reached: yellow %lld, blue %lld%s", terminal ? "\r" : "",
              simulated_s, so_far.scenario.duration_s, static_cast<long long>(so_far.reached_yellow),
              static_cast<long long>(so_far.reached_blue), terminal ? "  " : "\n");
  std::fflush(stdout);
}

/// Lets the viewer draw the log's scene at that time. Throws CommandError when that fails.
void draw(const std::string& log, const std::string& picture, double at_s) {
  const std::string viewer =
      (std::filesystem::read_symlink("/proc/self/exe").parent_path() / "regista-viewer").string();
  const std::string url = "file://" + std::filesystem::absolute(log).string();
  const std::string at = std::to_string(at_s);
  const pid_t child = fork();
  if (child == 0) {
    execl(viewer.c_str(), viewer.c_str(), "--lcm-url", url.c_str(), "--snapshot", picture.c_str(), "--at", at.c_str(),
          static_cast<char*>(nullptr));
    _exit(127);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw CommandError("the picture was not drawn; " + viewer + " says why above, or run with --no-picture");
  }
}

int run(const Options& options) {
  const Config config = Config::load(scenario_file(options.scenario), options.settings);
  const Scenario scenario = config.scenario();
  if (scenario.field_source != "sim") {
    throw CommandError("'" + scenario.name + "' is for a real field: start it with 'regista up', or add --set " +
                       "scenario.field_source=sim");
  }
  std::error_code refused;
  std::filesystem::create_directories(options.out, refused);
  if (refused) throw CommandError("cannot make the folder '" + options.out + "': " + refused.message());
  const std::string base = (std::filesystem::path(options.out) / scenario.name).string();
  RunOptions run_options;
  if (!options.no_log) run_options.log_file = base + ".lcmlog";
  run_options.on_progress = show_progress;
  run_options.stopped = stop_requested;
  const RunSummary summary = run_scenario(config, run_options, real_stopwatch());
  std::printf("%s%s", isatty(STDOUT_FILENO) == 1 ? "\n" : "", to_table(summary).c_str());
  if (!options.no_log) std::printf("log: %s\n", run_options.log_file.c_str());
  std::fflush(stdout);
  if (!options.no_log && !options.no_picture) {
    draw(run_options.log_file, base + ".png", summary.simulated_s / 2.0);
    std::printf("picture: %s.png\n", base.c_str());
  }
  return summary.violations.empty() ? 0 : 1;
}

}  // namespace

void add_run(CLI::App& app, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* sub = app.add_subcommand("run", "play a scenario in one process, in lock step, and sum it up");
  sub->add_option("scenario", options->scenario, "a .toml file or the name of a shipped one")->capture_default_str();
  sub->add_option("--set", options->settings, "section.key=value, over the file's; may be repeated")
      ->allow_extra_args(false);
  sub->add_option("--out", options->out, "folder for NAME.lcmlog and NAME.png")->capture_default_str();
  sub->add_flag("--no-log", options->no_log, "write neither log nor picture");
  sub->add_flag("--no-picture", options->no_picture, "write no picture");
  sub->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace regista
