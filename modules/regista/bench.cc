#include "modules/regista/bench.h"

#include <iostream>

#include "modules/bench/anytime_bench.h"
#include "modules/bench/ompl_grid_bench.h"
#include "modules/bench/paper/paper.h"
#include "modules/bench/scale_bench.h"
#include "modules/bench/static_bench.h"
#include "modules/bench/team_bench.h"
#include "modules/regista/bench_flags.h"

namespace regista {
namespace {

using bench::Run;

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
  const auto [command, flags] =
      add_one_bench(parent, action, "static", "every planner on 11 against 11", bench::run_static);
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
      add_one_bench(parent, action, "team", "a team on one shared graph against one query per robot", bench::run_team);
  add_count(*command, "--frames", flags->options.frames, "how many");
  add_planners(*command, flags->options.planners, "names, comma between; without it those that use the shared graph");
}

void add_anytime(CLI::App& parent, Action& action) {
  const auto [command, flags] = add_one_bench(
      parent, action, "anytime", "success and length of OMPL's planners against allowed time", bench::run_anytime);
  bench::AnytimeOptions& options = flags->options;
  add_count(*command, "--queries", options.queries, "per planner and time");
  add_planners(*command, options.planners, "names, comma between; without it those of OMPL; tangent is always there");
  command->add_option("--times-ms", options.times_ms, "allowed times, ms, comma between")
      ->delimiter(',')
      ->capture_default_str()
      ->check(CLI::Range(1e-3, 1e5));
}

void add_ompl_grid(CLI::App& parent, Action& action) {
  const auto [command, flags] = add_one_bench(
      parent, action, "ompl-grid", "the fastest good setting of OMPL's planners, and tangent", bench::run_ompl_grid);
  bench::GridOptions& options = flags->options;
  add_count(*command, "--queries", options.queries, "how many, at most");
  command->add_option("--grid", options.grid, "file of settings; without it the one shipped")->check(CLI::ExistingFile);
  add_batch(*command, options.batch);
  add_for(*command, options.for_s);
}

void add_scale(CLI::App& parent, Action& action) {
  const auto [command, flags] =
      add_one_bench(parent, action, "scale", "cost against obstacles, fleets and crowds", bench::run_scale);
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
  const auto [command, flags] = add_one_bench(
      parent, action, "paper", "a published table or figure, measured again beside the printed row", run_paper);
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
  CLI::App* command = app.add_subcommand("bench", "measure the planners and how teams drive: tables, CSV, plots");
  command->require_subcommand(1);
  add_static(*command, action);
  add_team(*command, action);
  add_anytime(*command, action);
  add_ompl_grid(*command, action);
  add_scale(*command, action);
  add_paper(*command, action);
  add_motion_benches(*command, action);
}

}  // namespace regista
