#include "modules/regista/bench.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "modules/bench/anytime_bench.h"
#include "modules/bench/ompl_grid_bench.h"
#include "modules/bench/paper/paper.h"
#include "modules/bench/scale_bench.h"
#include "modules/bench/static_bench.h"
#include "modules/bench/team_bench.h"
#include "planning/registry.h"

namespace regista {
namespace {

using bench::Run;

/// A bench's own options beside what all are told.
template <class Options>
struct Flags {
  Run run;
  Options options;
};

/// The subcommand with --out and --seed; calls measure(options, run).
template <class Options>
std::pair<CLI::App*, std::shared_ptr<Flags<Options>>> add(CLI::App& parent, Action& action, const char* name,
                                                          const char* help,
                                                          int (*measure)(const Options&, const Run&)) {
  CLI::App* command = parent.add_subcommand(name, help);
  const auto flags = std::make_shared<Flags<Options>>();
  flags->run.command = bench::own_command_line();
  command->add_option("--out", flags->run.out, "folder for tables (CSV) and plots (SVG, PNG)")->capture_default_str();
  command->add_option("--seed", flags->run.seed, "of the random worlds and planners")->capture_default_str();
  command->callback([flags, measure, &action] {
    action = [flags, measure] {
      try {
        return measure(flags->options, flags->run);
      } catch (const UnknownPlanner& error) {
        throw UsageError(error.what());
      }
    };
  });
  return {command, flags};
}

template <class T>
void add_count(CLI::App& command, const char* name, T& value, const char* help) {
  command.add_option(name, value, help)->capture_default_str()->check(CLI::Range(1.0, 1e9));
}

void add_batch(CLI::App& command, std::size_t& batch) {
  add_count(command, "--batch", batch, "queries in a row for each planner, before the next one's turn; 1: cold caches");
}

void add_for(CLI::App& command, double& for_s) {
  command.add_option("--for", for_s, "about how many seconds it may take")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 1e6));
}

void add_planners(CLI::App& command, std::vector<std::string>& planners, const char* help) {
  command.add_option("--planners", planners, help)->delimiter(',');
}

void add_static(CLI::App& parent, Action& action) {
  const auto [command, flags] = add(parent, action, "static", "every planner on 11 against 11", bench::run_static);
  bench::StaticOptions& options = flags->options;
  add_count(*command, "--queries", options.queries, "how many");
  add_planners(*command, options.planners, "names, comma between; without it all of: regista planner list");
  add_batch(*command, options.batch);
  command->add_option("--budget-us", options.budget_us, "time per query, us; 0: no limit")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e9));
  add_for(*command, options.for_s);
}

void add_team(CLI::App& parent, Action& action) {
  const auto [command, flags] =
      add(parent, action, "team", "a team on one shared graph against one query per robot", bench::run_team);
  add_count(*command, "--frames", flags->options.frames, "how many");
  add_planners(*command, flags->options.planners, "names, comma between; without it those that use the shared graph");
}

void add_anytime(CLI::App& parent, Action& action) {
  const auto [command, flags] =
      add(parent, action, "anytime", "success and length of OMPL's planners against allowed time", bench::run_anytime);
  bench::AnytimeOptions& options = flags->options;
  add_count(*command, "--queries", options.queries, "per planner and time");
  add_planners(*command, options.planners, "names, comma between; without it those of OMPL; tangent is always there");
  command->add_option("--times-ms", options.times_ms, "allowed times, ms, comma between")
      ->delimiter(',')
      ->capture_default_str()
      ->check(CLI::Range(1e-3, 1e5));
}

void add_ompl_grid(CLI::App& parent, Action& action) {
  const auto [command, flags] = add(parent, action, "ompl-grid",
                                    "the fastest good setting of OMPL's planners, and tangent", bench::run_ompl_grid);
  bench::GridOptions& options = flags->options;
  add_count(*command, "--queries", options.queries, "how many, at most");
  command->add_option("--grid", options.grid, "file of settings; without it the one shipped")->check(CLI::ExistingFile);
  add_batch(*command, options.batch);
  add_for(*command, options.for_s);
}

void add_scale(CLI::App& parent, Action& action) {
  const auto [command, flags] =
      add(parent, action, "scale", "cost against obstacles, fleets and crowds", bench::run_scale);
  bench::ScaleOptions& options = flags->options;
  add_count(*command, "--queries", options.queries, "per planner and number of obstacles, at most");
  add_count(*command, "--frames", options.frames, "per planner and size of the fleet, at most");
  add_planners(*command, options.planners, "names, comma between; without it tangent, visibility_sampling, rrt");
  for (const auto& [name, counts, help] : {std::tuple{"--obstacles", &options.obstacles, "numbers of obstacles"},
                                           std::tuple{"--robots", &options.robots, "sizes of fleets"},
                                           std::tuple{"--crowds", &options.crowds, "numbers of discs"}}) {
    command->add_option(name, *counts, help)->delimiter(',')->capture_default_str()->check(CLI::Range(1.0, 1e5));
  }
  add_for(*command, options.for_s);
}

struct PaperChoice {
  std::string table;
  bool list = false;
  bench::PaperOptions options;
};

int run_paper(const PaperChoice& choice, const Run& run) {
  if (choice.list) {
    bench::print_list(bench::paper_tables(), std::cout);
    return 0;
  }
  if (choice.table.empty()) throw UsageError("which table? regista bench paper --list names them");
  const bench::PaperTable* table = bench::find_paper_table(choice.table);
  if (table == nullptr) {
    std::vector<std::string> known;
    for (const bench::PaperTable& one : bench::paper_tables()) known.emplace_back(one.name);
    throw UsageError("no table '" + choice.table + "'; did you mean '" + nearest_name(choice.table, known) +
                     "'? regista bench paper --list names them all");
  }
  return table->run(choice.options, run);
}

void add_paper(CLI::App& parent, Action& action) {
  const auto [command, flags] =
      add(parent, action, "paper", "a published table or figure, measured again beside the printed row", run_paper);
  PaperChoice& choice = flags->options;
  command->add_option("table", choice.table, "name of the table");
  command->add_flag("--list", choice.list, "the tables there are");
  command->add_option("--samples", choice.options.samples, "per planner and scenario; 0: the paper's number")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e9));
  command->add_option("--budget-us", choice.options.budget_us, "time per query, us; 0: the paper's")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e9));
}

}  // namespace

void add_bench(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("bench", "measure the planners: tables, CSV, plots");
  command->require_subcommand(1);
  add_static(*command, action);
  add_team(*command, action);
  add_anytime(*command, action);
  add_ompl_grid(*command, action);
  add_scale(*command, action);
  add_paper(*command, action);
}

}  // namespace regista
