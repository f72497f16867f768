#include "modules/planner/planner_module.h"
#include "modules/process/module_main.h"

int main(int argc, char** argv) {
  using namespace regista;
  return module_main({.name = "planner",
                      .help = "Plans a team's paths: WORLD_STATE, GEOMETRY and TARGETS in, PLAN and GRAPH out.",
                      .per_team = true,
                      .make =
                          [](const ModuleContext& context) {
                            PlannerModuleParams params;
                            context.config.apply("planner", params, name(context.team));
                            return std::make_unique<PlannerModule>(context.bus, context.team, params,
                                                                   context.stopwatch);
                          }},
                     argc, argv);
}
