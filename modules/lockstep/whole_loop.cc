#include "modules/lockstep/whole_loop.h"

#include "modules/sim/sim_setup.h"

namespace regista {

SimModule& add_sim(LockStep& loop, const Config& config) {
  return loop.add<SimModule>(configured_setup(config, loop.now()));
}

WorldModelModule& add_world_model(LockStep& loop, const Config& config, const Stopwatch& stopwatch) {
  WorldModelParams params;
  config.apply("world_model", params);
  return loop.add<WorldModelModule>(params, stopwatch);
}

TaskModule& add_task(LockStep& loop, const Config& config) { return loop.add<TaskModule>(config.scenario()); }

PlannerModule& add_planner(LockStep& loop, const Config& config, Team team, const Stopwatch& stopwatch) {
  PlannerModuleParams params;
  config.apply("planner", params, name(team));
  params.planning.budget_us = 0;
  return loop.add<PlannerModule>(team, params, stopwatch);
}

ControllerModule& add_controller(LockStep& loop, const Config& config, Team team, const Stopwatch& stopwatch) {
  ControllerModuleParams params;
  config.apply("controller", params, name(team));
  return loop.add<ControllerModule>(team, params, stopwatch);
}

WholeLoop add_whole_loop(LockStep& loop, const Config& config, const Stopwatch& stopwatch) {
  WholeLoop modules;
  modules.sim = &add_sim(loop, config);
  modules.world_model = &add_world_model(loop, config, stopwatch);
  modules.task = &add_task(loop, config);
  for (const Team team : {Team::yellow, Team::blue}) {
    modules.planners[team] = &add_planner(loop, config, team, stopwatch);
  }
  for (const Team team : {Team::yellow, Team::blue}) {
    modules.controllers[team] = &add_controller(loop, config, team, stopwatch);
  }
  return modules;
}

}  // namespace regista
