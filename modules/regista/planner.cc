#include "modules/regista/planner.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "modules/process/module_program.h"
#include "modules/process/real_clock.h"
#include "modules/regista/bus_flag.h"
#include "modules/regista/service_client.h"
#include "planning/registry.h"

namespace regista {
namespace {

struct UseFlags {
  std::string lcm_url = default_lcm_url();
  std::string planner;
  std::string team;
};

std::string promises(const Guarantees& guarantees) {
  std::string text;
  const auto add = [&text](bool holds, const char* word) {
    if (holds) text += (text.empty() ? "" : ", ") + std::string(word);
  };
  add(guarantees.complete, "complete");
  add(guarantees.optimal, "optimal");
  add(guarantees.deterministic, "deterministic");
  add(guarantees.anytime, "anytime");
  return text.empty() ? "nothing" : text;
}

int list() {
  for (const PlannerEntry& entry : planners()) {
    fmt::print("{}{}\n    {}\n    source: {}\n    promises: {}\n", entry.name,
               entry.name == kDefaultPlanner ? " (default)" : "", entry.what, entry.source, promises(entry.guarantees));
  }
  return 0;
}

int use(const UseFlags& flags) {
  Bus bus(flags.lcm_url, real_clock());
  std::vector<Request> requests;
  for (const char* team : {"Y", "B"}) {
    if (!flags.team.empty() && flags.team != team) continue;
    requests.push_back(make_request(bus.now(), std::string("planner.") + team, "planner.use", flags.planner));
  }
  const auto replies = ask(bus, requests);
  int answered = 0;
  int status = 0;
  for (std::size_t i = 0; i < replies.size(); ++i) {
    if (!replies[i]) continue;
    ++answered;
    if (!replies[i]->accepted) status = 1;
    fmt::print(replies[i]->accepted ? stdout : stderr, "{}: {}\n", requests[i].module, replies[i]->text);
  }
  if (answered == 0) throw CommandError(no_answer(requests.front().module, flags.lcm_url));
  return status;
}

}  // namespace

void add_planner(CLI::App& app, Action& action) {
  CLI::App* planner = app.add_subcommand("planner", "list the planners, or swap them while the robots drive");
  planner->require_subcommand(1);
  const auto flags = std::make_shared<UseFlags>();
  CLI::App* list_command = planner->add_subcommand("list", "what there is, and what each promises");
  // Of no effect: the list is the program's own. All of the planner's commands take the same flag.
  add_bus_flag(*list_command, flags->lcm_url);
  list_command->callback([flags, &action] { action = list; });

  CLI::App* command = planner->add_subcommand("use", "plan with another planner from the next world state on");
  command->add_option("planner", flags->planner, "its name, see: regista planner list")->required();
  command->add_option("--team", flags->team, "Y (yellow) or B (blue); without it both")
      ->check(CLI::IsMember({"Y", "B"}));
  add_bus_flag(*command, flags->lcm_url);
  command->callback([flags, &action] { action = [flags] { return use(*flags); }; });
}

}  // namespace regista
