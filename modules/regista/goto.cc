#include "modules/regista/goto.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <numbers>

#include "modules/process/module_program.h"
#include "modules/regista/bus_flag.h"
#include "modules/regista/service_client.h"

namespace regista {
namespace {

struct Flags {
  std::string lcm_url = default_lcm_url();
  std::string robot;
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_deg = 0.0;
  bool release = false;
};

int send(const Flags& flags, bool has_place) {
  if (flags.release == has_place) throw UsageError("goto: give x and y, or --release");
  if (flags.release) return ask_and_print(flags.lcm_url, "task", "task.release", flags.robot);
  constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
  // Shortest text that gives the same numbers back.
  return ask_and_print(flags.lcm_url, "task", "task.goto", flags.robot,
                       fmt::format("{} {} {}", flags.x_m, flags.y_m, flags.heading_deg * kRadiansPerDegree));
}

}  // namespace

void add_goto(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("goto", "send one robot to a place");
  const auto flags = std::make_shared<Flags>();
  command->add_option("robot", flags->robot, "Y3, B10, …")->required();
  // More than any field, and still a number to calculate with.
  const CLI::Range coordinate(-1e4, 1e4);
  command->add_option("x", flags->x_m, "metres from the centre, towards the goal at +x")->check(coordinate);
  CLI::Option* y = command->add_option("y", flags->y_m, "metres from the centre, to the left of +x")->check(coordinate);
  command->add_option("heading", flags->heading_deg, "degrees, counter-clockwise from +x; 0 where not given")
      ->check(CLI::Range(-1e4, 1e4));
  command->add_flag("--release", flags->release, "instead: back to the scenario's task");
  add_bus_flag(*command, flags->lcm_url);
  command->callback(
      [flags, y, &action] { action = [flags, has_place = y->count() > 0] { return send(*flags, has_place); }; });
}

}  // namespace regista
