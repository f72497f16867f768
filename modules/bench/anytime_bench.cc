#include "modules/bench/anytime_bench.h"

#include <algorithm>
#include <cmath>

#include "modules/bench/bench.h"
#include "modules/bench/reference.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

/// What one planner did within one allowed time.
struct Curve {
  std::vector<double> length_m, length_ratio, time_us;
  std::size_t failures = 0;
};

struct BlockedScene {
  Scene scene;
  double optimum_m = 0.0;
};

/// Scenes in which the straight line is blocked and the reference finds a way.
std::vector<BlockedScene> blocked_scenes(Contender& reference, std::size_t count, const Run& run) {
  std::vector<BlockedScene> scenes;
  for (std::uint64_t i = 0; scenes.size() < count; ++i) {
    std::mt19937_64 random(mixed(run.seed, i));
    Scene scene = eleven_against_eleven(random);
    plan_once(reference, scene.world, scene.request);
    if (reference.answer.status != PlanStatus::ok || reference.answer.path.size() <= 2) continue;
    if (reference.answer.start_moved || reference.answer.goal_moved) continue;
    scene.request.budget.iterations = kUnlimitedIterations;
    scenes.push_back({std::move(scene), reference.answer.length_m});
  }
  return scenes;
}

Contenders contenders_of(const AnytimeOptions& options) {
  std::vector<std::string> names{reference_planner()};
  if (options.planners.empty()) {
    for (const char* name : {"rrt_connect", "rrt_star", "informed_rrt_star", "fmt_star", "bit_star"}) {
      if (is_registered(name)) names.emplace_back(name);
    }
  }
  for (const std::string& name : options.planners) {
    if (name != names.front()) names.push_back(name);
  }
  return make_contenders(names);
}

Table table_of(const Contenders& all, const AnytimeOptions& options, const std::vector<std::vector<Curve>>& curves,
               const Checker& checker) {
  Table table{std::string("anytime: success and length against allowed time, 11 against 11; lengths over those of ") +
                  reference_planner(),
              {{"planner"},
               {"allowed", "ms"},
               {"queries"},
               {"success", "%"},
               {"length mean", "m"},
               {"length sigma", "m"},
               {"ratio mean", "x", 5},
               {"ratio sigma", "x"},
               {"time mean", "us"},
               {"time max", "us"},
               {"faults of all times"}}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (std::size_t t = 0; t < options.times_ms.size(); ++t) {
      const Curve& curve = curves[k][t];
      const Summary length = summarise(curve.length_m, curve.failures);
      const Summary ratio = summarise(curve.length_ratio);
      const Summary time = summarise(curve.time_us);
      const auto where_any = [&](double value) { return length.count > 0 ? Cell{value} : Cell{}; };
      table.add({all[k].name, options.times_ms[t], count_cell(length.count + length.failures), 100.0 * length.success(),
                 where_any(length.mean), where_any(length.sigma), where_any(ratio.mean), where_any(ratio.sigma),
                 time.mean, time.max, count_cell(checker.faults(all[k].name))});
    }
  }
  table.notes = {
      "queries: free start and goal, the straight line blocked, a way known; success: a way within the time",
      "time: of the whole query, single shots; longer than allowed where a planner looks at the clock rarely"};
  return table;
}

/// Error bars of planners are drawn beside each other: each by this factor further right.
constexpr double kDodge = 1.025;
constexpr double kRoom = 1.25;  ///< beside the curves, for them

Series success_series(const std::string& name, const AnytimeOptions& options, const std::vector<Curve>& curves) {
  Series series{name, {}};
  for (std::size_t t = 0; t < options.times_ms.size(); ++t) {
    series.points.push_back({options.times_ms[t], 100.0 * summarise(curves[t].length_m, curves[t].failures).success()});
  }
  return series;
}

Series length_series(const std::string& name, const AnytimeOptions& options, const std::vector<Curve>& curves,
                     double dodge) {
  Series series{name, {}};
  for (std::size_t t = 0; t < options.times_ms.size(); ++t) {
    const Summary ratio = summarise(curves[t].length_ratio);
    if (ratio.count == 0) continue;
    series.points.push_back(
        {options.times_ms[t] * dodge, ratio.mean, std::pair{ratio.mean - ratio.sigma, ratio.mean + ratio.sigma}});
  }
  return series;
}

void measure(Contenders& all, const std::vector<BlockedScene>& scenes, const AnytimeOptions& options, Checker& checker,
             std::vector<std::vector<Curve>>& curves) {
  Progress progress("anytime", scenes.size());
  for (std::size_t i = 0; i < scenes.size(); ++i, progress.advance()) {
    const auto& [scene, optimum_m] = scenes[i];
    for (const std::size_t t : rotated(options.times_ms.size(), i)) {
      for (const std::size_t k : rotated(all.size(), i + t)) {
        const Shot shot = plan_once(all[k], scene.world, scene.request, 1e3 * options.times_ms[t]);
        Curve& curve = curves[k][t];
        curve.time_us.push_back(shot.total_us);
        const bool fine = checker.check(all[k].name, scene.world, scene.request, all[k].answer);
        if (fine && all[k].answer.status == PlanStatus::ok) {
          curve.length_m.push_back(all[k].answer.length_m);
          curve.length_ratio.push_back(all[k].answer.length_m / optimum_m);
        } else {
          ++curve.failures;
        }
      }
    }
  }
}

}  // namespace

int run_anytime(const AnytimeOptions& options, const Run& run) {
  Contenders all = contenders_of(options);
  Report report(run);
  Checker checker;
  const std::vector<BlockedScene> scenes = blocked_scenes(all.front(), options.queries, run);
  std::vector<std::vector<Curve>> curves(all.size(), std::vector<Curve>(options.times_ms.size()));
  measure(all, scenes, options, checker, curves);
  report.add("anytime", table_of(all, options, curves, checker));
  const auto [shortest_ms, longest_ms] = std::minmax_element(options.times_ms.begin(), options.times_ms.end());
  const Axis allowed{"allowed time", "ms", true, *shortest_ms / kRoom, *longest_ms * kRoom};
  Plot success{"anytime: how often there is a way within the time", allowed, {"success", "%", false, 0.0, 105.0}};
  Plot length{"anytime: length of the way, mean and standard deviation",
              allowed,
              {std::string("length over that of ") + reference_planner(), "", false, 0.95, 1.6}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    success.series.push_back(success_series(all[k].name, options, curves[k]));
    length.series.push_back(length_series(all[k].name, options, curves[k], std::pow(kDodge, static_cast<double>(k))));
  }
  report.add("anytime_success", success);
  report.add("anytime_length", length);
  return report.finish(checker);
}

}  // namespace regista::bench
