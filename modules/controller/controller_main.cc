#include "modules/controller/controller_module.h"
#include "modules/process/module_main.h"

int main(int argc, char** argv) {
  using namespace regista;
  return module_main(
      {.name = "controller",
       .help = "Drives a team along its plans: WORLD_STATE and PLAN in, COMMANDS out; brakes when they go quiet.",
       .per_team = true,
       .make =
           [](const ModuleContext& context) {
             ControllerModuleParams params;
             context.config.apply("controller", params, name(context.team));
             return std::make_unique<ControllerModule>(context.bus, context.team, params, context.stopwatch);
           }},
      argc, argv);
}
