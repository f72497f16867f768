#include "modules/process/module_program.h"

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace regista {
namespace {

// The only state a signal handler may touch.
volatile std::sig_atomic_t stop_signalled = 0;

void on_signal(int) { stop_signalled = 1; }

void install_signal_handlers() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

struct Flags {
  std::string lcm_url = default_lcm_url();
  std::string config_file;
  std::vector<std::string> settings;
  std::string team;
};

void add_common_flags(CLI::App& app, const ModuleProgram& program, Flags& flags) {
  app.add_option("--lcm-url", flags.lcm_url, "LCM bus, for example udpm://239.255.76.67:7667?ttl=0")
      ->capture_default_str();
  app.add_option("--config", flags.config_file, "scenario: a .toml file or the name of a shipped one");
  app.add_option("--set", flags.settings, "section.key=value, over the file's; may be repeated")
      ->allow_extra_args(false);
  if (program.per_team) {
    app.add_option("--team", flags.team, "Y (yellow) or B (blue)")->required()->check(CLI::IsMember({"Y", "B"}));
  }
}

void run_until_stopped(const ModuleProgram& program, Module& module, ProcessLoop& loop) {
  if (program.run) {
    program.run(module, loop, stop_requested);
    return;
  }
  // A signal that comes just before the wait is seen after it at the latest.
  constexpr Duration kLongestWait = std::chrono::milliseconds(100);
  while (!stop_requested()) loop.step(kLongestWait);
}

}  // namespace

bool stop_requested() {
  static const bool installed = (install_signal_handlers(), true);
  return installed && stop_signalled != 0;
}

std::string default_lcm_url() {
  const char* from_environment = std::getenv("LCM_DEFAULT_URL");
  if (from_environment != nullptr && *from_environment != '\0') return from_environment;
  return "udpm://239.255.76.67:7667?ttl=0&recv_buf_size=8388608";
}

int module_main(const ModuleProgram& program, int argc, char** argv) {
  CLI::App app{program.help, "regista-" + program.name};
  Flags flags;
  add_common_flags(app, program, flags);
  if (program.add_flags) program.add_flags(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    stop_requested();  // from here on a signal ends the program in order
    const Config config =
        Config::load(flags.config_file.empty() ? "" : scenario_file(flags.config_file), flags.settings);
    Bus bus(program.bus_url ? program.bus_url(flags.lcm_url) : flags.lcm_url, real_clock());
    const Team team = flags.team == "B" ? Team::blue : Team::yellow;
    const std::unique_ptr<Module> module = program.make({bus, config, team, real_stopwatch()});
    ProcessLoop loop(*module, bus, real_stopwatch());
    run_until_stopped(program, *module, loop);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "regista-%s: %s\n", program.name.c_str(), error.what());
    return 1;
  }
  return 0;
}

}  // namespace regista
