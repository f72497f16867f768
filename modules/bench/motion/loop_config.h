// From what is typed to the parts of a closed loop, through the same configuration as the modules have.
#pragma once

#include <string>
#include <vector>

#include "modules/bench/motion/closed_loop.h"
#include "modules/bench/motion/system_driver.h"
#include "modules/process/config.h"

namespace regista::bench {

/// How our team is driven, and what it is told to believe.
struct SystemChoice {
  std::string planner;                ///< "": what [planner] says, by default the default
  std::string safety;                 ///< value of controller.safety.mode; "": the default
  std::vector<std::string> settings;  ///< "planner.key=value", "controller.key=value", "sim.key=value", …
};

/// 11 against 11 of that preset on that division. Throws ConfigError.
Config loop_config(const SystemChoice& choice, const std::string& preset, const std::string& division = "A");

/// Throws ConfigError and UnknownPlanner.
SystemParams system_params(const Config& config, Team team);

/// Simulator and world model of that configuration, nobody driving. Throws ConfigError.
LoopSetup loop_setup(const Config& config, std::uint64_t seed);

}  // namespace regista::bench
