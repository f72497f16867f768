#include "modules/bench/paper/sbp_sweep.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "modules/bench/reference.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

constexpr double kNormal95 = 1.96;  ///< quantile of the normal distribution at 97.5 %

constexpr double kHalf_percent = 50.0;

/// Error bars of planners are drawn beside each other: each by this factor further right.
constexpr double kDodge = 1.02;
constexpr double kRoom = 1.25;  ///< beside the curves, for them

Summary lengths_of(const SweepPoint& point) { return summarise(point.length_m, point.failures); }

double blocked_share(const SweepPoint& point) {
  return point.blocked > 0 ? static_cast<double>(point.blocked_solved) / static_cast<double>(point.blocked) : 0.0;
}

/// A scene and what is known about it.
struct Known {
  Scene scene;
  bool is_blocked = false;
  std::optional<double> optimum_m = {};
};

Known known_scene(const SbpScenario& scenario, Contender& reference, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Known known{sbp_scene(scenario, random)};
  known.scene.request.budget.iterations = kUnlimitedIterations;
  plan_once(reference, known.scene.world, known.scene.request);
  if (reference.answer.status == PlanStatus::ok) known.optimum_m = reference.answer.length_m;
  known.is_blocked = !reference.graph.field().is_free(known.scene.request.start, known.scene.request.goal,
                                                      known.scene.request.ignored);
  return known;
}

void shoot(SweepPoint& point, const Known& known, Checker& checker) {
  Contender& contender = point.contender;
  const Shot shot = plan_once(contender, known.scene.world, known.scene.request, point.budget_us);
  point.time_us.push_back(shot.total_us);
  const bool fine = checker.check(contender.name, known.scene.world, known.scene.request, contender.answer);
  const bool solved = fine && contender.answer.status == PlanStatus::ok;
  point.blocked += known.is_blocked ? 1U : 0U;
  point.blocked_solved += known.is_blocked && solved ? 1U : 0U;
  if (!solved) {
    ++point.failures;
    return;
  }
  point.length_m.push_back(contender.answer.length_m);
  if (known.optimum_m) point.length_ratio.push_back(contender.answer.length_m / *known.optimum_m);
}

/// The value and half the width of its confidence interval.
std::optional<std::pair<double, double>> value_of(const SweepPoint& point, const std::string& quantity) {
  const Summary length = lengths_of(point);
  if (quantity == "success") {
    return std::pair{100.0 * length.success(), confidence_of_percent(length.success(), length.count + length.failures)};
  }
  if (quantity == "success_blocked") {
    if (point.blocked == 0) return {};
    return std::pair{100.0 * blocked_share(point), confidence_of_percent(blocked_share(point), point.blocked)};
  }
  if (quantity == "time") return std::pair{summarise(point.time_us).mean, 0.0};
  const Summary ratio = summarise(point.length_ratio);
  if (quantity != "length" && quantity != "sigma" && quantity != "ratio" && quantity != "ratio_sigma") {
    throw std::runtime_error("no quantity '" + quantity + "'");
  }
  const Summary& summary = quantity.starts_with("ratio") ? ratio : length;
  if (summary.count == 0) return {};
  if (quantity == "length" || quantity == "ratio") return std::pair{summary.mean, confidence_of_mean(summary)};
  return std::pair{summary.sigma, confidence_of_sigma(summary)};
}

/// The first place of a curve where that many percent of the blocked scenes succeed, between places along the
/// logarithm.
std::optional<double> place_of_success(const std::vector<SweepPoint>& curve, double percent) {
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double here = 100.0 * blocked_share(curve[i]);
    if (here < percent) continue;
    if (i == 0) return curve[i].x;
    const double before = 100.0 * blocked_share(curve[i - 1]);
    return curve[i - 1].x * std::pow(curve[i].x / curve[i - 1].x, (percent - before) / (here - before));
  }
  return {};
}

}  // namespace

double confidence_of_mean(const Summary& summary) {
  return summary.count < 2 ? 0.0 : kNormal95 * summary.sigma / std::sqrt(static_cast<double>(summary.count));
}

double confidence_of_sigma(const Summary& summary) {
  return summary.count < 2 ? 0.0 : kNormal95 * summary.sigma / std::sqrt(2.0 * static_cast<double>(summary.count - 1));
}

double confidence_of_percent(double share, std::size_t count) {
  return count < 2 ? 0.0 : 100.0 * kNormal95 * std::sqrt(share * (1.0 - share) / static_cast<double>(count));
}

void measure(Sweep& sweep, const SbpScenario& scenario, std::size_t runs, const std::string& what, const Run& run,
             Checker& checker) {
  Contenders reference = make_contenders({reference_planner()});
  Progress progress(what, runs);
  for (std::size_t i = 0; i < runs; ++i, progress.advance()) {
    const Known known = known_scene(scenario, reference.front(), mixed(run.seed, i));
    for (const std::size_t k : rotated(sweep.curves.size(), i)) {
      for (const std::size_t x : rotated(sweep.curves[k].size(), i)) shoot(sweep.curves[k][x], known, checker);
    }
  }
}

Table table_of(const Sweep& sweep, const std::string& title) {
  Table table{title,
              {{"planner"},
               {sweep.x_name, sweep.x_unit},
               {"runs"},
               {"success", "%"},
               {"success where blocked", "%"},
               {"length mean", "m"},
               {"+-", "m", 3},
               {"length sigma", "m"},
               {"+-", "m", 3},
               {"ratio mean", "x", 5},
               {"ratio sigma", "x"},
               {"time mean", "us"},
               {"time max", "us"}}};
  for (const std::vector<SweepPoint>& curve : sweep.curves) {
    for (const SweepPoint& point : curve) {
      const Summary length = lengths_of(point);
      const Summary ratio = summarise(point.length_ratio);
      const Summary time = summarise(point.time_us);
      const auto where_any = [&](double value) { return length.count > 0 ? Cell{value} : Cell{}; };
      table.add({point.contender.name, point.x, count_cell(length.count + length.failures), 100.0 * length.success(),
                 point.blocked > 0 ? Cell{100.0 * blocked_share(point)} : Cell{}, where_any(length.mean),
                 where_any(confidence_of_mean(length)), where_any(length.sigma), where_any(confidence_of_sigma(length)),
                 where_any(ratio.mean), where_any(ratio.sigma), time.mean, time.max});
    }
  }
  table.notes = {
      "+-: half the 95 % confidence interval; ratio: length over that of the exact planner on the same scene",
      "our planners take a free straight line at once, the paper's did not: compare its success with 'where blocked'",
      "the figures' numbers are lost; what the text says of them is in the table of findings"};
  return table;
}

Measurement measurement_of(const Sweep& sweep) {
  return [&sweep](const std::string& quantity, const std::string& planner, double at) -> std::optional<double> {
    for (const std::vector<SweepPoint>& curve : sweep.curves) {
      if (quantity == "half_success_at" && curve.front().contender.name == planner) {
        return place_of_success(curve, kHalf_percent);
      }
      for (const SweepPoint& point : curve) {
        if (point.contender.name != planner || point.x != at) continue;
        const auto value = value_of(point, quantity);
        return value ? std::optional(value->first) : std::nullopt;
      }
    }
    throw std::runtime_error("nothing was measured for " + planner + " at " + std::to_string(at));
  };
}

Plot plot_of(const Sweep& sweep, const std::string& title, const Axis& y, const std::string& quantity) {
  Plot plot{title, {sweep.x_name, sweep.x_unit, true}, y};
  for (std::size_t k = 0; k < sweep.curves.size(); ++k) {
    Series series{sweep.curves[k].front().contender.name, {}};
    for (const SweepPoint& point : sweep.curves[k]) {
      plot.x.low = std::min(plot.x.low.value_or(point.x / kRoom), point.x / kRoom);
      plot.x.high = std::max(plot.x.high.value_or(point.x * kRoom), point.x * kRoom);
      const auto value = value_of(point, quantity);
      if (!value) continue;
      const auto& [middle, half] = *value;
      series.points.push_back(
          {point.x * std::pow(kDodge, static_cast<double>(k)), middle, std::pair{middle - half, middle + half}});
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace regista::bench
