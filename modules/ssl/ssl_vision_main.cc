#include "modules/process/module_program.h"
#include "modules/ssl/ssl_vision_module.h"

int main(int argc, char** argv) {
  regista::ModuleProgram program;
  program.name = "ssl-vision";
  program.help = "Receives SSL-Vision packets of any number of cameras and publishes VISION and GEOMETRY.";
  program.make = [](const regista::ModuleContext& context) {
    regista::SslVisionParams params;
    context.config.apply("ssl_vision", params);
    return std::make_unique<regista::SslVisionModule>(context.bus, params);
  };
  program.run = regista::run_socket_module;
  return regista::module_main(program, argc, argv);
}
