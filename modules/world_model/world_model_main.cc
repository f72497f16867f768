#include "modules/process/module_program.h"
#include "modules/setup/module_setup.h"
#include "modules/world_model/world_model_module.h"

int main(int argc, char** argv) {
  using namespace regista;
  return module_main({.name = "world-model",
                      .help = "Estimates where everything is: VISION and COMMANDS in, WORLD_STATE out.",
                      .make =
                          [](const ModuleContext& context) {
                            return std::make_unique<WorldModelModule>(
                                context.bus, world_model_params_of(context.config), context.stopwatch);
                          }},
                     argc, argv);
}
