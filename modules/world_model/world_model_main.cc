#include "modules/process/module_main.h"
#include "modules/world_model/world_model_module.h"

int main(int argc, char** argv) {
  using namespace regista;
  return module_main({.name = "world-model",
                      .help = "Estimates where everything is: VISION and COMMANDS in, WORLD_STATE out.",
                      .make =
                          [](const ModuleContext& context) {
                            WorldModelParams params;
                            context.config.apply("world_model", params);
                            return std::make_unique<WorldModelModule>(context.bus, params, context.stopwatch);
                          }},
                     argc, argv);
}
