#include "modules/regista/up.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>

#include "modules/lockstep/whole_loop.h"
#include "modules/process/module_program.h"
#include "modules/process/real_clock.h"
#include "modules/regista/bus_flag.h"
#include "modules/regista/external_tool.h"
#include "modules/regista/launcher.h"
#include "modules/ssl/ssl_radio_module.h"
#include "modules/ssl/ssl_referee_module.h"
#include "modules/ssl/ssl_vision_module.h"

namespace regista {
namespace {

struct Flags {
  LaunchOptions launch;
  double for_s = 0.0;  ///< 0: until told to stop
  std::map<std::string, bool> without;
};

/// Throws ConfigError for what any module would refuse to start with.
void check_all_parameters(const Config& config) {
  check_parameters(config);
  SslVisionParams vision;
  config.apply("ssl_vision", vision);
  SslRefereeParams referee;
  config.apply("ssl_referee", referee);
  SslRadioParams radio;
  config.apply("ssl_radio", radio);
}

int up(Flags flags) {
  // Configuration errors are told once, here, and not by eight modules.
  const std::string file = scenario_file(flags.launch.scenario);
  const Config config = Config::load(file, flags.launch.settings);
  check_all_parameters(config);
  flags.launch.real_field = config.scenario().field_source == "ssl";
  flags.launch.stated_referee = !config.scenario().referee.empty();
  for (const auto& [module, left_out] : flags.without) {
    if (left_out) flags.launch.left_out.push_back(module);
  }
  if (flags.launch.viewer && std::getenv("DISPLAY") == nullptr) {
    throw CommandError("no display for --viewer: set DISPLAY, or start without it and use 'regista-viewer --snapshot'");
  }
  stop_requested();  // from here on a signal ends the modules in order
  Bus bus(flags.launch.lcm_url, real_clock());
  Display display;
  Launcher launcher(bus, modules_for(flags.launch), own_folder(), display);
  const std::optional<Time> end =
      flags.for_s > 0.0 ? std::optional(bus.now() + from_seconds(flags.for_s)) : std::nullopt;
  constexpr Duration kStep = std::chrono::milliseconds(100);
  while (!stop_requested() && (!end || bus.now() < *end) && launcher.given_up() < launcher.size()) {
    launcher.step(kStep);
  }
  launcher.stop();
  if (launcher.given_up() > 0) throw CommandError("not all modules could be kept running, see above");
  return 0;
}

}  // namespace

void add_up(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("up", "start a scenario's modules, watch and restart them until Ctrl-C");
  const auto flags = std::make_shared<Flags>();
  flags->launch.scenario = "crossing";
  command->add_option("scenario", flags->launch.scenario, "a .toml file or the name of a shipped one")
      ->capture_default_str();
  flags->launch.lcm_url = default_lcm_url();
  add_bus_flag(*command, flags->launch.lcm_url);
  command->add_option("--set", flags->launch.settings, "section.key=value for all modules; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--for", flags->for_s, "seconds after which to stop; without it until Ctrl-C")
      ->check(CLI::PositiveNumber);
  command->add_flag("--viewer", flags->launch.viewer, "with a window");
  for (const std::string& module : module_names()) {
    if (module == "viewer") continue;
    command->add_flag("--no-" + module, flags->without[module], "do not start it: it runs elsewhere");
  }
  command->callback([flags, &action] { action = [flags] { return up(*flags); }; });
}

}  // namespace regista
