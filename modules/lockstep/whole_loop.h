// The whole system in lock step from one configuration: simulator, world model, task, planner and controller per team.
#pragma once

#include "modules/controller/controller_module.h"
#include "modules/lockstep/lock_step.h"
#include "modules/planner/planner_module.h"
#include "modules/process/config.h"
#include "modules/sim/sim_module.h"
#include "modules/task/task_module.h"
#include "modules/world_model/world_model_module.h"

namespace regista {

/// The modules of a loop that a runner looks at; they live in the LockStep.
struct WholeLoop {
  SimModule& sim;
  TaskModule& task;
};

/// Adds all modules, in the order of the data's way. Measured times come from the stopwatch; planning budgets in
/// microseconds are switched off, for they would make the run depend on the machine. Throws ConfigError.
WholeLoop add_whole_loop(LockStep& loop, const Config& config, const Stopwatch& stopwatch);

}  // namespace regista
