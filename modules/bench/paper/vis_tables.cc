#include "modules/bench/paper/vis_tables.h"

#include <fmt/core.h>

#include <functional>

#include "modules/bench/paper/vis_race.h"
#include "modules/bench/paper/vis_scenes.h"
#include "modules/bench/reference.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

/// Those of the data that the run's own allows, and that.
std::vector<double> budgets_within(const DataTable& table, double budget_ms) {
  std::vector<double> budgets_ms = table.numbers("full_budgets_ms");
  std::erase_if(budgets_ms, [&](double shorter_ms) { return shorter_ms >= budget_ms; });
  budgets_ms.push_back(budget_ms);
  return budgets_ms;
}

int run_race(const std::string& name, const std::string& title, const DataTable& table, const PaperOptions& options,
             const Run& run, const std::vector<std::string>& notes, const std::function<Scene(std::size_t)>& scene_of) {
  const double budget_us = options.budget_us > 0.0 ? options.budget_us : 1e3 * table.number("budget_ms");
  const std::size_t runs = options.samples > 0 ? options.samples : table.count("runs");
  std::vector<Racer> racers = racers_of(table);
  Report report(run);
  Checker checker;
  Progress progress(name, runs);
  Contenders reference = make_contenders({reference_planner()});
  std::size_t without_path = 0;
  std::size_t with_a_way = 0;
  for (std::size_t i = 0; i < runs; ++i, progress.advance()) {
    const Scene scene = scene_of(i);
    if (race(racers, scene, budget_us, i, checker)) continue;
    ++without_path;
    plan_once(reference.front(), scene.world, scene.request);
    with_a_way += reference.front().answer.status == PlanStatus::ok ? 1U : 0U;
  }
  Table times = table_of(racers, title);
  times.notes.insert(times.notes.end(), notes.begin(), notes.end());
  times.notes.push_back(
      fmt::format("full budget {:g} ms; left out, as visibility_sampling found no path: {}, of which {} have one",
                  1e-3 * budget_us, without_path, with_a_way));
  report.add(name, times);
  const std::vector<double> budgets_ms = budgets_within(table, 1e-3 * budget_us);
  const std::string ratio_title = title + ": RRT* over visibility_sampling";
  report.add(name + "_ratio", ratios_of(racers, ratio_title, budgets_ms));
  report.add(name + "_ratio", ratio_plot_of(racers, ratio_title + ", blocked, means", budgets_ms));
  report.add(name, times_of(racers, title + ", straight line blocked"));
  return report.finish(checker);
}

}  // namespace

int run_vis_wall(const PaperOptions& options, const Run& run) {
  const DataTable wall = DataTable(kVisFile).table("wall");
  const Scene scene = wall_scene(wall);
  return run_race("vis-wall", "Visibility sampling: 31 plannings behind a wall of robots", wall, options, run,
                  {"the picture is lost: the wall is rebuilt from the text, see the data file"}, [&](std::size_t i) {
                    Scene again = scene;
                    again.request.seed = mixed(run.seed, i);
                    return again;
                  });
}

int run_vis_agents(const PaperOptions& options, const Run& run) {
  const DataTable agents = DataTable(kVisFile).table("agents");
  const std::size_t robots = agents.count("robots_per_team");
  return run_race(
      "vis-agents", "Visibility sampling: plannings with 12 agents", agents, options, run,
      {"printed as RRT* 0.43, proposed 2.61; the sentence below it ('becomes inefficient when the number of "
       "agents increases') agrees,",
       "the conclusion ('outperforms [...] RRT*') and the first table do not: the columns may be swapped"},
      [&](std::size_t i) {
        std::mt19937_64 random(mixed(run.seed, i));
        return agents_scene(robots, random);
      });
}

}  // namespace regista::bench
