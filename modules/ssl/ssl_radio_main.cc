#include "modules/process/module_program.h"
#include "modules/ssl/ssl_radio_module.h"

int main(int argc, char** argv) {
  regista::ModuleProgram program;
  program.name = "ssl-radio";
  program.help =
      "Sends COMMANDS to a simulator or radio that speaks the SSL simulation protocol, and reports its errors.";
  program.make = [](const regista::ModuleContext& context) {
    regista::SslRadioParams params;
    context.config.apply("ssl_radio", params);
    return std::make_unique<regista::SslRadioModule>(context.bus, params);
  };
  program.run = regista::run_socket_module;
  return regista::module_main(program, argc, argv);
}
