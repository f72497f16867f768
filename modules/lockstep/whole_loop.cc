#include "modules/lockstep/whole_loop.h"

#include "modules/sim/sim_setup.h"

namespace regista {
namespace {

void add_planner(LockStep& loop, const Config& config, Team team, const Stopwatch& stopwatch) {
  PlannerModuleParams params;
  config.apply("planner", params, name(team));
  params.planning.budget_us = 0;
  loop.add<PlannerModule>(team, params, stopwatch);
}

void add_controller(LockStep& loop, const Config& config, Team team, const Stopwatch& stopwatch) {
  ControllerModuleParams params;
  config.apply("controller", params, name(team));
  loop.add<ControllerModule>(team, params, stopwatch);
}

}  // namespace

WholeLoop add_whole_loop(LockStep& loop, const Config& config, const Stopwatch& stopwatch) {
  WorldModelParams world_model;
  config.apply("world_model", world_model);
  SimModule& sim = loop.add<SimModule>(configured_setup(config, loop.now()));
  loop.add<WorldModelModule>(world_model, stopwatch);
  TaskModule& task = loop.add<TaskModule>(config.scenario());
  for (const Team team : {Team::yellow, Team::blue}) add_planner(loop, config, team, stopwatch);
  for (const Team team : {Team::yellow, Team::blue}) add_controller(loop, config, team, stopwatch);
  return {sim, task};
}

}  // namespace regista
