#include "modules/bench/paper/sbp_tracking.h"

#include <algorithm>
#include <stdexcept>

#include "modules/bench/bench.h"
#include "modules/bench/paper/sampling_findings.h"
#include "modules/bench/paper/sbp_scenario.h"
#include "modules/bench/reference.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

struct Settings {
  double step_m = 0.0;  ///< way of the robot between two frames
  double budget_us = 0.0;
  std::size_t iterations_max = 0;
};

/// A planner and what its robots did.
struct Tracker {
  Contender contender;
  bool keeps_waypoints = false;
  std::vector<double> iterations = {}, way_m = {};  ///< of runs that arrived
  std::size_t lost = 0;                             ///< runs that did not
  std::size_t plans = 0, failures = 0;
  std::vector<double> distance_sum_m = {};  ///< by iteration, of all runs
};

/// The path after `step_m` of it.
std::vector<Vec2> advanced(const std::vector<Vec2>& path, double step_m) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double leg_m = (path[i] - path[i - 1]).norm();
    if (step_m < leg_m) {
      std::vector<Vec2> rest{path[i - 1] + (path[i] - path[i - 1]) * (step_m / leg_m)};
      rest.insert(rest.end(), path.begin() + static_cast<std::ptrdiff_t>(i), path.end());
      return rest;
    }
    step_m -= leg_m;
  }
  return {path.back()};
}

void drive(Tracker& tracker, Scene scene, const Settings& settings, Checker& checker) {
  const Vec2 goal = scene.request.goal;
  std::vector<Vec2> path{scene.request.start};
  double way_m = 0.0;
  tracker.distance_sum_m.resize(settings.iterations_max + 1, 0.0);
  for (std::size_t i = 0; i <= settings.iterations_max; ++i) {
    const double distance_m = (goal - path.front()).norm();
    tracker.distance_sum_m[i] += distance_m;
    if (distance_m == 0.0) {
      tracker.iterations.push_back(static_cast<double>(i));
      tracker.way_m.push_back(way_m);
      return;
    }
    scene.request.start = path.front();
    scene.request.seed = mixed(scene.request.seed, i);
    scene.request.previous_path = tracker.keeps_waypoints ? path : std::vector<Vec2>();
    plan_once(tracker.contender, scene.world, scene.request, settings.budget_us);
    ++tracker.plans;
    const Plan& plan = tracker.contender.answer;
    if (checker.check(tracker.contender.name, scene.world, scene.request, plan) && plan.status == PlanStatus::ok) {
      path = plan.path;
    } else {
      ++tracker.failures;
    }
    way_m += std::min(settings.step_m, length_of(path));
    path = advanced(path, settings.step_m);
  }
  ++tracker.lost;
}

/// The first random configuration in which the straight line is blocked and there is a way.
std::pair<Scene, double> configuration(const SbpScenario& scenario, std::uint64_t seed) {
  Contenders reference = make_contenders({reference_planner()});
  for (std::uint64_t i = 0;; ++i) {
    std::mt19937_64 random(mixed(seed, i));
    Scene scene = sbp_scene(scenario, random);
    scene.request.budget.iterations = kUnlimitedIterations;
    plan_once(reference.front(), scene.world, scene.request);
    const Plan& answer = reference.front().answer;
    if (answer.status == PlanStatus::ok && answer.path.size() > 2) return {std::move(scene), answer.length_m};
  }
}

Table table_of(const std::vector<Tracker>& trackers, double shortest_m) {
  Table table{"Pinheiro et al., figure 10: an ideal tracker, planning anew with every frame",
              {{"planner"},
               {"runs"},
               {"arrived", "%"},
               {"iterations mean"},
               {"iterations sigma"},
               {"way / shortest", "x", 5},
               {"plans without a path", "%"}}};
  for (const Tracker& tracker : trackers) {
    const Summary iterations = summarise(tracker.iterations, tracker.lost);
    const bool any = iterations.count > 0;
    table.add({tracker.contender.name, count_cell(iterations.count + iterations.failures), 100.0 * iterations.success(),
               any ? Cell{iterations.mean} : Cell{}, any ? Cell{iterations.sigma} : Cell{},
               any ? Cell{summarise(tracker.way_m).mean / shortest_m} : Cell{},
               100.0 * static_cast<double>(tracker.failures) / static_cast<double>(std::max(tracker.plans, 1UL))});
  }
  table.notes = {"one random configuration, as published; iterations: frames until the goal is reached",
                 "the figure's numbers are lost; what the text says of it is in the table of findings"};
  return table;
}

Measurement measurement_of(const std::vector<Tracker>& trackers) {
  return [&trackers](const std::string& quantity, const std::string& planner, double) -> std::optional<double> {
    if (quantity != "iterations") throw std::runtime_error("no quantity '" + quantity + "'");
    for (const Tracker& tracker : trackers) {
      if (tracker.contender.name != planner) continue;
      if (tracker.iterations.empty()) return {};
      return summarise(tracker.iterations).mean;
    }
    throw std::runtime_error("nothing was measured for " + planner);
  };
}

/// Distance at an iteration, mean of the runs.
double distance_m(const Tracker& tracker, std::size_t iteration, std::size_t runs) {
  return tracker.distance_sum_m[iteration] / static_cast<double>(runs);
}

Plot distances_of(const std::vector<Tracker>& trackers, std::size_t runs) {
  Plot plot{"Pinheiro et al., figure 10: distance to the goal, mean of the runs",
            {"replanning iteration"},
            {"distance", "m"}};
  for (const Tracker& tracker : trackers) {
    Series series{tracker.contender.name, {}, Series::Style::line};
    for (std::size_t i = 0; i < tracker.distance_sum_m.size(); ++i) {
      series.points.push_back({static_cast<double>(i), distance_m(tracker, i, runs)});
      if (tracker.distance_sum_m[i] == 0.0) break;
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

/// The curves lie upon each other: how far each is behind the first planner's, which is exact.
Plot lags_of(const std::vector<Tracker>& trackers, std::size_t runs) {
  Plot plot{"Pinheiro et al., figure 10: how far behind the shortest path, mean of the runs",
            {"replanning iteration"},
            {"distance to the goal, more than that of " + trackers.front().contender.name, "m"}};
  for (std::size_t k = 1; k < trackers.size(); ++k) {
    Series series{trackers[k].contender.name, {}, Series::Style::line};
    for (std::size_t i = 0; i < trackers[k].distance_sum_m.size(); ++i) {
      series.points.push_back(
          {static_cast<double>(i), distance_m(trackers[k], i, runs) - distance_m(trackers.front(), i, runs)});
      if (trackers[k].distance_sum_m[i] == 0.0) break;
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace

int run_sbp_tracking(const PaperOptions& options, const Run& run) {
  const DataTable data(kSbpFile);
  const DataTable figure = data.table("tracking");
  const Settings settings{figure.number("speed_mps") / data.table("budget").number("camera_hz"),
                          options.budget_us > 0.0 ? options.budget_us : sbp_budget_us(data),
                          figure.count("iterations_max")};
  std::vector<Tracker> trackers;
  for (const DataTable& row : figure.tables("planner")) {
    trackers.push_back({contender_of(row), row.has("keeps_waypoints") && row.flag("keeps_waypoints")});
  }
  const std::size_t runs = runs_or(options.samples, figure);
  const auto [scene, shortest_m] = configuration(sbp_scenario(data), run.seed);
  Report report(run);
  Checker checker;
  Progress progress("sbp-figure10", runs);
  for (std::size_t i = 0; i < runs; ++i, progress.advance()) {
    Scene again = scene;
    again.request.seed = mixed(scene.request.seed, i);
    for (const std::size_t k : rotated(trackers.size(), i)) drive(trackers[k], again, settings, checker);
  }
  report.add("sbp-figure10", table_of(trackers, shortest_m));
  report.add("sbp-figure10_findings", findings_table("Pinheiro et al., figure 10: what the text says",
                                                     figure.tables("finding"), measurement_of(trackers)));
  report.add("sbp-figure10", distances_of(trackers, runs));
  report.add("sbp-figure10_behind", lags_of(trackers, runs));
  return report.finish(checker);
}

}  // namespace regista::bench
