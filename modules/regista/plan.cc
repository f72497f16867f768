#include "modules/regista/plan.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "modules/process/real_clock.h"
#include "modules/regista/plan_answer.h"
#include "planning/registry.h"

namespace regista {
namespace {

struct Flags {
  std::string planner{kDefaultPlanner};
  int repeat = 1;
};

std::unique_ptr<Planner> planner_named(const std::string& name) {
  try {
    return make_planner(name);
  } catch (const UnknownPlanner& error) {
    throw UsageError(error.what());
  }
}

int plan(const Flags& flags) {
  const std::unique_ptr<Planner> planner = planner_named(flags.planner);
  const Stopwatch stopwatch = real_stopwatch();
  std::ios::sync_with_stdio(false);
  for (std::string line; std::getline(std::cin, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    // Flushed, so that a program can ask, read, and ask again.
    std::cout << answer_line(line, *planner, flags.planner, flags.repeat, stopwatch) << std::endl;
    if (!std::cout) throw CommandError("cannot write the answers: is the disk full?");
  }
  return 0;
}

}  // namespace

void add_plan(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("plan", "plan queries from standard input, one JSON object per line");
  const auto flags = std::make_shared<Flags>();
  command->add_option("--planner", flags->planner, "its name, see: regista planner list")->capture_default_str();
  command->add_option("--repeat", flags->repeat, "plan so often and tell the least time")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  command->callback([flags, &action] { action = [flags] { return plan(*flags); }; });
}

}  // namespace regista
