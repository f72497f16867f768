// regista: the one command a person types.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "modules/regista/bench.h"
#include "modules/regista/command.h"
#include "modules/regista/command_line.h"
#include "modules/regista/goto.h"
#include "modules/regista/log.h"
#include "modules/regista/param.h"
#include "modules/regista/plan.h"
#include "modules/regista/planner.h"
#include "modules/regista/record.h"
#include "modules/regista/referee.h"
#include "modules/regista/replay.h"
#include "modules/regista/run.h"
#include "modules/regista/spy.h"
#include "modules/regista/up.h"

namespace {

int run(int argc, char** argv) {
  CLI::App app{"Controls teams of robots over LCM: vision in, velocity commands out.", "regista"};
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return std::string("regista: ") + error.what() + "; see --help\n";
  });
  regista::Action action;
  regista::add_up(app, action);
  regista::add_run(app, action);
  regista::add_planner(app, action);
  regista::add_param(app, action);
  regista::add_goto(app, action);
  regista::add_referee(app, action);
  regista::add_record(app, action);
  regista::add_replay(app, action);
  regista::add_spy(app, action);
  regista::add_log(app, action);
  regista::add_plan(app, action);
  regista::add_bench(app, action);
  std::vector<std::string> arguments = regista::arguments_of(argc, argv);
  if (const auto unknown = regista::unknown_command(app, arguments)) {
    std::fprintf(stderr, "regista: %s\n", unknown->c_str());
    return 2;
  }
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes a list
  try {
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    return action();
  } catch (const regista::UsageError& error) {
    std::fprintf(stderr, "regista: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "regista: %s\n", error.what());
    return 1;
  }
}

}  // namespace

int main(int argc, char** argv) { return run(argc, argv); }
