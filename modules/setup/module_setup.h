// Every module's parameters from a configuration, in one place: what the scenario's field is known to be like comes
// first, the module's own section over it. All throw ConfigError.
#pragma once

#include "modules/controller/controller_module.h"
#include "modules/planner/planner_module.h"
#include "modules/process/config.h"
#include "sim/simulator.h"
#include "world_model/world_model.h"

namespace regista {

/// The scenario's field, formation and preset, [sim] over the preset.
SimSetup sim_setup_of(const Config& config, Time start);

/// Of a simulated field the delays, the lag and the noise of vision are known; [world_model] goes over them.
WorldModelParams world_model_params_of(const Config& config);

PlannerModuleParams planner_params_of(const Config& config, Team team);

/// Of a simulated field the lag of the robots is known; [controller] goes over it.
ControllerModuleParams controller_params_of(const Config& config, Team team);

}  // namespace regista
