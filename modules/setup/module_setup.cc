#include "modules/setup/module_setup.h"

#include <algorithm>

namespace regista {
namespace {

bool is_simulated(const Config& config) { return config.scenario().field_source == "sim"; }

SimParams sim_params_of(const Config& config) { return sim_setup_of(config, Time{}).params; }

}  // namespace

SimSetup sim_setup_of(const Config& config, Time start) {
  SimSetup setup = sim_setup(config.scenario(), start);
  config.apply("sim", setup.params);
  return setup;
}

WorldModelParams world_model_params_of(const Config& config) {
  WorldModelParams params;
  if (is_simulated(config)) {
    const SimParams sim = sim_params_of(config);
    params.latency_s = sim.vision.latency_s + sim.radio.latency_s;
    params.velocity_lag_s = sim.velocity_lag_s;
    // The league's noise at the least, also on a field without any.
    params.robot.position_sigma_m = std::max(params.robot.position_sigma_m, sim.vision.robot_sigma_m);
    params.robot.heading_sigma_rad = std::max(params.robot.heading_sigma_rad, sim.vision.heading_sigma_rad);
  }
  config.apply("world_model", params);
  return params;
}

PlannerModuleParams planner_params_of(const Config& config, Team team) {
  PlannerModuleParams params;
  config.apply("planner", params, name(team));
  return params;
}

ControllerModuleParams controller_params_of(const Config& config, Team team) {
  ControllerModuleParams params;
  if (is_simulated(config)) params.control.drive_lag_s = sim_params_of(config).velocity_lag_s;
  config.apply("controller", params, name(team));
  try {
    TeamWheels(params.control.wheels, params.control.robot_wheels);
  } catch (const std::invalid_argument& error) {
    throw ConfigError(std::string("controller: ") + error.what());
  }
  return params;
}

}  // namespace regista
