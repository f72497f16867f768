#include "modules/process/module_program.h"
#include "modules/ssl/ssl_referee_module.h"

int main(int argc, char** argv) {
  regista::ModuleProgram program;
  program.name = "ssl-referee";
  program.help = "Receives the league's referee messages and publishes REFEREE.";
  program.make = [](const regista::ModuleContext& context) {
    regista::SslRefereeParams params;
    context.config.apply("ssl_referee", params);
    return std::make_unique<regista::SslRefereeModule>(context.bus, params);
  };
  program.run = regista::run_socket_module;
  return regista::module_main(program, argc, argv);
}
