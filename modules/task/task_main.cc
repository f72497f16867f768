#include "modules/process/module_program.h"
#include "modules/task/task_module.h"

int main(int argc, char** argv) {
  using namespace regista;
  return module_main({.name = "task",
                      .help = "Tells robots where to be, as the scenario says: WORLD_STATE in, TARGETS out.",
                      .make =
                          [](const ModuleContext& context) {
                            return std::make_unique<TaskModule>(context.bus, context.config.scenario());
                          }},
                     argc, argv);
}
