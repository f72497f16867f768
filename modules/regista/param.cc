#include "modules/regista/param.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "modules/process/module_program.h"
#include "modules/regista/bus_flag.h"
#include "modules/regista/service_client.h"

namespace regista {
namespace {

struct Flags {
  std::string lcm_url = default_lcm_url();
  std::string module;
  std::string key;
  std::string value;
};

CLI::App* add_verb(CLI::App& param, const std::string& verb, const std::string& help,
                   const std::shared_ptr<Flags>& flags, Action& action) {
  CLI::App* command = param.add_subcommand(verb, help);
  command->add_option("module", flags->module, "for example sim, world-model, planner.Y, controller.B")->required();
  add_bus_flag(*command, flags->lcm_url);
  command->callback([flags, verb, &action] {
    action = [flags, verb] {
      return ask_and_print(flags->lcm_url, flags->module, "param." + verb, flags->key, flags->value);
    };
  });
  return command;
}

}  // namespace

void add_param(CLI::App& app, Action& action) {
  CLI::App* param = app.add_subcommand("param", "list, read and set a running module's parameters");
  param->require_subcommand(1);
  const auto flags = std::make_shared<Flags>();
  add_verb(*param, "list", "all with value, unit and meaning", flags, action);
  CLI::App* get = add_verb(*param, "get", "one value", flags, action);
  get->add_option("key", flags->key, "the parameter")->required();
  CLI::App* set = add_verb(*param, "set", "one value, from the module's next tick on", flags, action);
  set->add_option("key", flags->key, "the parameter")->required();
  set->add_option("value", flags->value, "its new value")->required();
}

}  // namespace regista
