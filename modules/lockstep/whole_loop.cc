#include "modules/lockstep/whole_loop.h"

#include <array>

#include "modules/setup/module_setup.h"

namespace regista {
namespace {

constexpr std::array kTeams{Team::yellow, Team::blue};

}  // namespace

SimModule& add_sim(LockStep& loop, const Config& config) {
  return loop.add<SimModule>(sim_setup_of(config, loop.now()));
}

WorldModelModule& add_world_model(LockStep& loop, const Config& config, const Stopwatch& stopwatch) {
  return loop.add<WorldModelModule>(world_model_params_of(config), stopwatch);
}

TaskModule& add_task(LockStep& loop, const Config& config) { return loop.add<TaskModule>(config.scenario()); }

PlannerModule& add_planner(LockStep& loop, const Config& config, Team team, const Stopwatch& stopwatch) {
  PlannerModuleParams params = planner_params_of(config, team);
  params.planning.budget_us = 0;
  params.planning.frame_period_s = 0.0;
  return loop.add<PlannerModule>(team, params, stopwatch);
}

ControllerModule& add_controller(LockStep& loop, const Config& config, Team team, const Stopwatch& stopwatch) {
  return loop.add<ControllerModule>(team, controller_params_of(config, team), stopwatch);
}

void check_parameters(const Config& config) {
  sim_setup_of(config, Time{});
  world_model_params_of(config);
  for (const Team team : kTeams) {
    try {
      planner_entry(planner_params_of(config, team).use);
    } catch (const UnknownPlanner& error) {
      throw ConfigError(error.what());
    }
    controller_params_of(config, team);
  }
}

WholeLoop add_whole_loop(LockStep& loop, const Config& config, const Stopwatch& stopwatch) {
  check_parameters(config);
  WholeLoop modules;
  modules.sim = &add_sim(loop, config);
  modules.world_model = &add_world_model(loop, config, stopwatch);
  modules.task = &add_task(loop, config);
  for (const Team team : kTeams) modules.planners[team] = &add_planner(loop, config, team, stopwatch);
  for (const Team team : kTeams) modules.controllers[team] = &add_controller(loop, config, team, stopwatch);
  return modules;
}

}  // namespace regista
