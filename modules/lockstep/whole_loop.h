// The whole system in lock step from one configuration: simulator, world model, task, planner and controller per team.
#pragma once

#include <map>

#include "modules/controller/controller_module.h"
#include "modules/lockstep/lock_step.h"
#include "modules/planner/planner_module.h"
#include "modules/process/config.h"
#include "modules/sim/sim_module.h"
#include "modules/task/task_module.h"
#include "modules/world_model/world_model_module.h"

namespace regista {

/// The loop's modules, for whoever scores, kills or restarts them; they live in the LockStep.
struct WholeLoop {
  SimModule* sim = nullptr;
  WorldModelModule* world_model = nullptr;
  TaskModule* task = nullptr;
  std::map<Team, PlannerModule*> planners;
  std::map<Team, ControllerModule*> controllers;
};

// Each adds one module, configured by its section. Measured times come from the stopwatch. Planning budgets in
// microseconds are switched off, for they would make the run depend on the machine. All throw ConfigError.
SimModule& add_sim(LockStep& loop, const Config& config);
WorldModelModule& add_world_model(LockStep& loop, const Config& config, const Stopwatch& stopwatch);
TaskModule& add_task(LockStep& loop, const Config& config);
PlannerModule& add_planner(LockStep& loop, const Config& config, Team team, const Stopwatch& stopwatch);
ControllerModule& add_controller(LockStep& loop, const Config& config, Team team, const Stopwatch& stopwatch);

/// Checks all sections for these modules without making one. Throws ConfigError.
void check_parameters(const Config& config);

/// All of them, in the order of the data's way.
WholeLoop add_whole_loop(LockStep& loop, const Config& config, const Stopwatch& stopwatch);

}  // namespace regista
