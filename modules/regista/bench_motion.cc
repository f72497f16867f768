#include "modules/bench/motion/cost_bench.h"
#include "modules/bench/motion/crowd_bench.h"
#include "modules/bench/motion/dynamic_bench.h"
#include "modules/bench/motion/margins_bench.h"
#include "modules/bench/motion/motion_bench.h"
#include "modules/bench/motion/swap_bench.h"
#include "modules/regista/bench_flags.h"

namespace regista {
namespace {

void add_settings(CLI::App& command, std::vector<std::string>& settings) {
  command
      .add_option("--set", settings,
                  "planner.key=value, controller.key=value, world_model.key=value or sim.key=value; may be repeated")
      ->allow_extra_args(false);
}

/// How the team under test is driven.
void add_system(CLI::App& command, bench::SystemChoice& system) {
  command.add_option("--planner", system.planner, "our planner, see: regista planner list");
  command.add_option("--safety", system.safety, "our safety search, as controller.safety.mode");
  add_settings(command, system.settings);
}

void add_seed_set(CLI::App& command, bench::SeedSet& seeds) {
  command
      .add_option("--seeds", seeds,
                  "tuning or reporting: parameters are chosen on the first, numbers told of the second")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, bench::SeedSet>{{"tuning", bench::SeedSet::tuning},
                                                                        {"reporting", bench::SeedSet::reporting}})
              .description("{tuning,reporting}"));
}

void add_names(CLI::App& command, const char* name, std::vector<std::string>& values, const char* help,
               std::vector<std::string> known) {
  command.add_option(name, values, help)->delimiter(',')->capture_default_str()->check(CLI::IsMember(std::move(known)));
}

void add_preset(CLI::App& command, std::string& preset) {
  command.add_option("--preset", preset, "of the simulator")
      ->capture_default_str()
      ->check(CLI::IsMember({"none", "noisy", "realistic"}));
}

void add_crowd(CLI::App& parent, Action& action) {
  const auto [command, flags] =
      add_one_bench(parent, action, "crowd", "a team to random targets among another: contacts, faults, pace, cost",
                    bench::run_crowd);
  bench::CrowdOptions& options = flags->options;
  command->add_option("--minutes", options.minutes, "simulated, per field, preset and opponents")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 1e5));
  add_names(*command, "--preset", options.presets, "of the simulator, comma between", {"none", "noisy", "realistic"});
  add_names(*command, "--field", options.fields, "divisions, comma between", {"A", "B"});
  add_names(*command, "--opponents", options.opponents,
            "system: as we are; random: straight, avoiding nobody; chaser: towards us; comma between",
            {"system", "random", "chaser"});
  command->add_flag("!--no-pass-through", options.pass_through, "leave out the pace without others");
  add_system(*command, options.system);
  add_seed_set(*command, options.seeds);
  add_count(*command, "--jobs", options.jobs, "games at once");
}

void add_swap(CLI::App& parent, Action& action) {
  const auto [command, flags] = add_one_bench(
      parent, action, "swap", "robots in each other's way: swaps on a circle, a corridor, a target occupied, a chaser",
      bench::run_swap);
  bench::SwapOptions& options = flags->options;
  add_count(*command, "--runs", options.runs, "per scene");
  add_preset(*command, options.preset);
  command->add_option("--scenes", options.scenes, "words of their names, comma between; without it all")
      ->delimiter(',');
  add_system(*command, options.system);
  add_seed_set(*command, options.seeds);
  add_count(*command, "--jobs", options.jobs, "scenes at once");
}

void add_motion(CLI::App& parent, Action& action) {
  const auto [command, flags] = add_one_bench(
      parent, action, "motion", "one robot against the least time, alone and among standing robots", bench::run_motion);
  bench::MotionOptions& options = flags->options;
  add_count(*command, "--moves", options.moves, "free moves, per set of limits");
  add_count(*command, "--drives", options.drives, "among standing robots, per preset");
  add_names(*command, "--preset", options.presets, "of the drives, comma between", {"none", "noisy", "realistic"});
  add_system(*command, options.system);
  add_seed_set(*command, options.seeds);
  add_count(*command, "--jobs", options.jobs, "moves at once");
}

void add_dynamic(CLI::App& parent, Action& action) {
  const auto [command, flags] = add_one_bench(
      parent, action, "dynamic", "tables 8 to 11 of the DVG paper, with the system driving", bench::run_dynamic);
  bench::DynamicOptions& options = flags->options;
  add_count(*command, "--drives", options.drives, "per scenario, preset, planner and safety search");
  command->add_option("--planners", options.planners, "names, comma between")->delimiter(',')->capture_default_str();
  command->add_option("--safety", options.safety, "values of controller.safety.mode, comma between")
      ->delimiter(',')
      ->capture_default_str();
  add_names(*command, "--preset", options.presets, "of the simulator, comma between", {"none", "noisy", "realistic"});
  add_settings(*command, options.settings);
  add_seed_set(*command, options.seeds);
  add_count(*command, "--jobs", options.jobs, "drives at once");
}

void add_margins(CLI::App& parent, Action& action) {
  const auto [command, flags] = add_one_bench(parent, action, "margins",
                                              "contacts inside a team against its margin, where robots are not as "
                                              "modelled",
                                              bench::run_margins);
  bench::MarginsOptions& options = flags->options;
  command->add_option("--minutes", options.minutes, "simulated, per error and margin")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 1e5));
  command->add_option("--margins-mm", options.margins_mm, "margins, mm, comma between")
      ->delimiter(',')
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1000.0));
  add_system(*command, options.system);
  add_seed_set(*command, options.seeds);
  add_count(*command, "--jobs", options.jobs, "runs at once");
}

void add_cost(CLI::App& parent, Action& action) {
  const auto [command, flags] =
      add_one_bench(parent, action, "cost", "time of a tick: planning, control, safety search", bench::run_cost);
  bench::CostOptions& options = flags->options;
  command->add_option("--minutes", options.minutes, "simulated, per safety search")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 1e5));
  command->add_option("--safety", options.safety, "values of controller.safety.mode, comma between")
      ->delimiter(',')
      ->capture_default_str();
  add_preset(*command, options.preset);
  command->add_option("--planner", options.system.planner, "see: regista planner list");
  add_settings(*command, options.system.settings);
  add_seed_set(*command, options.seeds);
}

}  // namespace

void add_motion_benches(CLI::App& parent, Action& action) {
  add_crowd(parent, action);
  add_swap(parent, action);
  add_motion(parent, action);
  add_dynamic(parent, action);
  add_margins(parent, action);
  add_cost(parent, action);
}

}  // namespace regista
