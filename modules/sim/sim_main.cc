#include "modules/process/module_program.h"
#include "modules/setup/module_setup.h"
#include "modules/sim/sim_module.h"

int main(int argc, char** argv) {
  using namespace regista;
  return module_main({.name = "sim",
                      .help = "Simulates the field: COMMANDS in, VISION, GEOMETRY and TRUTH out.",
                      .make =
                          [](const ModuleContext& context) {
                            return std::make_unique<SimModule>(context.bus,
                                                               sim_setup_of(context.config, context.bus.now()));
                          }},
                     argc, argv);
}
