#include "modules/bench/motion/loop_config.h"

#include <algorithm>

#include "modules/setup/module_setup.h"

namespace regista::bench {

Config loop_config(const SystemChoice& choice, const std::string& preset, const std::string& division) {
  std::vector<std::string> settings{"scenario.sim_preset=" + preset, "scenario.field.division=" + division};
  if (!choice.planner.empty()) settings.push_back("planner.use=" + choice.planner);
  if (!choice.safety.empty()) settings.push_back("controller.safety.mode=" + choice.safety);
  settings.insert(settings.end(), choice.settings.begin(), choice.settings.end());
  return Config::load("", settings);
}

SystemParams system_params(const Config& config, Team team) {
  PlannerModuleParams planner = planner_params_of(config, team);
  // No clock runs in a closed loop: budgets are counts.
  planner.planning.budget_us = 0;
  planner.planning.frame_period_s = 0.0;
  planner_entry(planner.use);
  return {planner.use, planner.planning, controller_params_of(config, team).control};
}

LoopSetup loop_setup(const Config& config, std::uint64_t seed) {
  LoopSetup setup;
  setup.sim = sim_setup_of(config, Time{});
  setup.sim.seed = seed;
  setup.model = world_model_params_of(config);
  return setup;
}

}  // namespace regista::bench
