#include "modules/planner/planner_module.h"
#include "modules/process/module_program.h"
#include "modules/setup/module_setup.h"

int main(int argc, char** argv) {
  using namespace regista;
  return module_main({.name = "planner",
                      .help = "Plans a team's paths: WORLD_STATE, GEOMETRY and TARGETS in, PLAN and GRAPH out.",
                      .per_team = true,
                      .make =
                          [](const ModuleContext& context) {
                            return std::make_unique<PlannerModule>(context.bus, context.team,
                                                                   planner_params_of(context.config, context.team),
                                                                   context.stopwatch);
                          }},
                     argc, argv);
}
