#include "modules/process/module_main.h"
#include "modules/sim/sim_module.h"
#include "modules/sim/sim_setup.h"

int main(int argc, char** argv) {
  using namespace regista;
  return module_main({.name = "sim",
                      .help = "Simulates the field: COMMANDS in, VISION, GEOMETRY and TRUTH out.",
                      .make =
                          [](const ModuleContext& context) {
                            return std::make_unique<SimModule>(context.bus,
                                                               configured_setup(context.config, context.bus.now()));
                          }},
                     argc, argv);
}
