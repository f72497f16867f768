// The main function of every module's executable: flags, configuration, signals, the loop, one-line errors.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "modules/bus/module.h"
#include "modules/process/config.h"
#include "modules/process/process_loop.h"

namespace CLI {
class App;
}

namespace regista {

/// What a module is made from.
struct ModuleContext {
  Bus& bus;
  const Config& config;
  Team team = Team::yellow;  ///< meaningful for modules that are there once per team
  Stopwatch stopwatch;
};

struct ModuleProgram {
  std::string name;       ///< the executable is regista-<name>
  std::string help;       ///< what it does, one sentence
  bool per_team = false;  ///< takes --team Y|B
  std::function<std::unique_ptr<Module>(const ModuleContext&)> make;
  std::function<void(CLI::App&)> add_flags = {};  ///< the program's own flags, parsed before make
  /// The bus to open, from the one given; for a program that reads a log its own way.
  std::function<std::string(const std::string& url)> bus_url = {};
  /// Instead of the plain loop, for a program that must own the main thread (a window). Returns when `stopped()`.
  std::function<void(Module&, ProcessLoop&, const std::function<bool()>& stopped)> run = {};
};

/// Exit status 0 after SIGINT or SIGTERM, 1 on an error, 2 on wrong usage.
int module_main(const ModuleProgram& program, int argc, char** argv);

/// True once SIGINT or SIGTERM has come in; the handlers are installed by the first call.
bool stop_requested();

/// The bus URL where --lcm-url is not given: LCM_DEFAULT_URL, else LCM's own default with a receive buffer that holds a
/// fleet's messages.
std::string default_lcm_url();

}  // namespace regista
