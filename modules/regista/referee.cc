#include "modules/regista/referee.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "modules/process/module_program.h"
#include "modules/regista/bus_flag.h"
#include "modules/regista/service_client.h"
#include "world_model/types/game_state.h"

namespace regista {
namespace {

struct Flags {
  std::string lcm_url = default_lcm_url();
  std::string command;
  double x_m = 0.0;
  double y_m = 0.0;
};

int send(const Flags& flags, bool has_place) {
  const std::string place = has_place ? fmt::format("{} {}", flags.x_m, flags.y_m) : "";
  return ask_and_print(flags.lcm_url, "task", "task.referee", flags.command, place);
}

}  // namespace

void add_referee(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("referee", "say what the referee says: halt, stop, ball_placement_blue, …");
  const auto flags = std::make_shared<Flags>();
  command->add_option("command", flags->command, "the referee's command")
      ->required()
      ->check(CLI::IsMember(command_texts()));
  const CLI::Range coordinate(-1e3, 1e3);
  CLI::Option* x = command->add_option("x", flags->x_m, "metres, where the ball is to be placed")->check(coordinate);
  CLI::Option* y = command->add_option("y", flags->y_m, "metres, where the ball is to be placed")->check(coordinate);
  x->needs(y);
  add_bus_flag(*command, flags->lcm_url);
  command->callback(
      [flags, y, &action] { action = [flags, has_place = y->count() > 0] { return send(*flags, has_place); }; });
}

}  // namespace regista
