#include "modules/controller/controller_module.h"
#include "modules/process/module_program.h"
#include "modules/setup/module_setup.h"

int main(int argc, char** argv) {
  using namespace regista;
  return module_main(
      {.name = "controller",
       .help = "Drives a team along its plans: WORLD_STATE and PLAN in, COMMANDS out; brakes when they go quiet.",
       .per_team = true,
       .make =
           [](const ModuleContext& context) {
             return std::make_unique<ControllerModule>(
                 context.bus, context.team, controller_params_of(context.config, context.team), context.stopwatch);
           }},
      argc, argv);
}
