#include "modules/bench/static_bench.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "modules/bench/bench.h"
#include "modules/bench/pacing.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

constexpr const char* kReference = "tangent";

/// Arcs leave the exact planner as polylines up to this much longer (planning/planners/tangent.h).
constexpr double kRounding = 1e-3;

/// Queries that are thrown away: they warm up memory and tell how slow a planner is.
constexpr std::uint64_t kTrialQueries = 20;
constexpr double kTrialMax_s = 0.5;  ///< per planner
/// Of the allowed time; the rest is for making worlds, and for queries slower than the trial ones.
constexpr double kPlanningShare = 0.85;

struct Measured {
  std::size_t asked = 0;
  std::size_t solvable = 0;  ///< of these, queries that some planner solved
  std::size_t solved = 0;
  std::vector<double> total_us, plan_us, length_ratio;
};

Scene scene_of(std::uint64_t seed, std::uint64_t query) {
  std::mt19937_64 random(mixed(seed, query));
  return eleven_against_eleven(random);
}

std::vector<double> trial(Contenders& contenders, const StaticOptions& options, const Run& run) {
  std::vector<double> query_s;
  for (Contender& contender : contenders) {
    const SingleShot since;
    std::uint64_t done = 0;
    for (; done < kTrialQueries && since.s() < kTrialMax_s; ++done) {
      const Scene scene = scene_of(~run.seed, done);
      plan_once(contender, scene.world, scene.request, options.budget_us);
    }
    query_s.push_back(since.s() / static_cast<double>(done));
  }
  return query_s;
}

/// One batch of queries and what each planner answered to each; nothing where it was not asked.
struct Batch {
  std::vector<Scene> scenes;
  std::vector<std::vector<std::optional<Plan>>> answers;  ///< by planner, by scene

  /// The shortest length known for a scene: of the reference, or of all where there is none.
  std::optional<double> optimum(const Contenders& contenders, std::size_t scene, bool with_reference) const {
    std::optional<double> best;
    for (std::size_t k = 0; k < contenders.size(); ++k) {
      const std::optional<Plan>& answer = answers[k][scene];
      if (!answer || answer->status != PlanStatus::ok) continue;
      if (with_reference && contenders[k].name != kReference) continue;
      if (!best || answer->length_m < *best) best = answer->length_m;
    }
    return best;
  }
};

/// The whole batch by one planner; queries of `first` on that are its turn.
void ask(Contender& contender, Batch& batch, std::size_t planner, std::size_t first, std::size_t every,
         double budget_us, Measured& measured) {
  for (std::size_t i = 0; i < batch.scenes.size(); ++i) {
    if ((first + i) % every != 0) continue;
    const Shot shot = plan_once(contender, batch.scenes[i].world, batch.scenes[i].request, budget_us);
    measured.total_us.push_back(shot.total_us);
    measured.plan_us.push_back(shot.plan_us);
    batch.answers[planner][i] = contender.answer;
  }
}

/// Faulty answers are counted and from then on none.
void check(const Contenders& contenders, Batch& batch, Checker& checker) {
  for (std::size_t i = 0; i < batch.scenes.size(); ++i) {
    for (std::size_t k = 0; k < contenders.size(); ++k) {
      std::optional<Plan>& answer = batch.answers[k][i];
      if (!answer || checker.check(contenders[k].name, batch.scenes[i].world, batch.scenes[i].request, *answer))
        continue;
      answer->status = PlanStatus::not_found;
    }
  }
}

void evaluate(const Contenders& contenders, const Batch& batch, Checker& checker, std::vector<Measured>& measured) {
  const bool with_reference = is_registered(kReference);
  for (std::size_t i = 0; i < batch.scenes.size(); ++i) {
    const std::optional<double> any_m = batch.optimum(contenders, i, false);
    const std::optional<double> best_m = batch.optimum(contenders, i, with_reference);
    if (any_m && best_m && *any_m < *best_m * (1.0 - kRounding)) {
      checker.add_fault(kReference, fmt::format("{} m is not the shortest, {} m is", *best_m, *any_m));
    }
    for (std::size_t k = 0; k < contenders.size(); ++k) {
      const std::optional<Plan>& answer = batch.answers[k][i];
      if (!answer) continue;
      const bool solved = answer->status == PlanStatus::ok;
      ++measured[k].asked;
      measured[k].solvable += any_m ? 1U : 0U;
      measured[k].solved += solved ? 1U : 0U;
      if (solved && best_m && *best_m > 0.0) measured[k].length_ratio.push_back(answer->length_m / *best_m);
    }
  }
}

void measure(Contenders& contenders, const std::vector<std::size_t>& every, const StaticOptions& options,
             const Run& run, Checker& checker, std::vector<Measured>& measured) {
  Progress progress("static", options.queries);
  for (std::size_t first = 0, round = 0; first < options.queries; first += options.batch, ++round) {
    Batch batch;
    for (std::size_t i = first; i < std::min(first + options.batch, options.queries); ++i) {
      batch.scenes.push_back(scene_of(run.seed, i));
    }
    batch.answers.assign(contenders.size(), std::vector<std::optional<Plan>>(batch.scenes.size()));
    for (const std::size_t k : rotated(contenders.size(), round)) {
      ask(contenders[k], batch, k, first, every[k], options.budget_us, measured[k]);
    }
    check(contenders, batch, checker);
    evaluate(contenders, batch, checker, measured);
    progress.advance(batch.scenes.size());
  }
}

Table table_of(const Contenders& contenders, const std::vector<Measured>& measured, const Checker& checker,
               const StaticOptions& options) {
  const bool with_reference = is_registered(kReference);
  Table table;
  table.title = "static: 11 against 11 on 12 x 9 m; lengths over those of ";
  table.title += with_reference ? kReference : "the best of all planners on each query (tangent is not there)";
  table.columns = {{"planner"},
                   {"queries"},
                   {"solvable"},
                   {"success", "%", 5},
                   {"length mean", "x", 5},
                   {"length p99", "x", 5},
                   {"time mean", "us"},
                   {"p50", "us"},
                   {"p99", "us"},
                   {"max", "us"},
                   {"plan only mean", "us"},
                   {"plan p50", "us"},
                   {"plan p99", "us"},
                   {"faults"}};
  for (std::size_t k = 0; k < contenders.size(); ++k) {
    const Measured& m = measured[k];
    const Summary total = summarise(m.total_us);
    const Summary plan = summarise(m.plan_us);
    const Summary ratio = summarise(m.length_ratio);
    const double success = m.solvable == 0 ? 0.0 : static_cast<double>(m.solved) / static_cast<double>(m.solvable);
    table.add({contenders[k].name, count_cell(m.asked), count_cell(m.solvable), 100.0 * success,
               ratio.count > 0 ? Cell{ratio.mean} : Cell{}, ratio.count > 0 ? Cell{ratio.p99} : Cell{}, total.mean,
               total.p50, total.p99, total.max, plan.mean, plan.p50, plan.p99,
               count_cell(checker.faults(contenders[k].name))});
  }
  table.notes = {
      fmt::format("time: one query from nothing, field and graph laid out and planned, single shots; planners take "
                  "turns, {} quer{} each",
                  options.batch, options.batch == 1 ? "y" : "ies"),
      "success: of the queries that have a way as far as is known (solvable)",
      fmt::format("budget {:.0f} us a query; slow planners get every k-th query, see their count", options.budget_us)};
  return table;
}

Plot time_plot(const Contenders& contenders, const std::vector<Measured>& measured) {
  Plot plot{"static: time per query, all building included (box: quartiles, whiskers: least and longest)",
            {"planner"},
            {"time", "µs", true}};
  for (std::size_t k = 0; k < contenders.size(); ++k) {
    plot.boxes.push_back({contenders[k].name, summarise(measured[k].total_us)});
  }
  return plot;
}

Plot quality_plot(const Contenders& contenders, const std::vector<Measured>& measured) {
  Plot plot{"static: how long it takes and how long the way is, means",
            {"time per query", "µs", true},
            {"length above the optimum", "%"}};
  double longest_percent = 1.0;
  for (std::size_t k = 0; k < contenders.size(); ++k) {
    const Summary ratio = summarise(measured[k].length_ratio);
    if (ratio.count == 0) continue;
    const double excess_percent = 100.0 * (ratio.mean - 1.0);
    plot.series.push_back(
        {contenders[k].name, {{summarise(measured[k].total_us).mean, excess_percent}}, Series::Style::marks});
    longest_percent = std::max(longest_percent, excess_percent);
  }
  // Room below, or the best would sit on the axis.
  plot.y.low = -0.04 * longest_percent;
  return plot;
}

}  // namespace

int run_static(const StaticOptions& options, const Run& run) {
  std::vector<std::string> names = options.planners;
  const bool lacks_reference = std::find(names.begin(), names.end(), kReference) == names.end();
  if (!names.empty() && lacks_reference && is_registered(kReference)) names.insert(names.begin(), kReference);
  Contenders contenders = make_contenders(names);
  Report report(run);
  const std::vector<std::size_t> every =
      strides(trial(contenders, options, run), options.queries, kPlanningShare * options.for_s);
  std::vector<Measured> measured(contenders.size());
  Checker checker;
  measure(contenders, every, options, run, checker, measured);
  report.add("static", table_of(contenders, measured, checker, options));
  report.add("static_time", time_plot(contenders, measured));
  report.add("static_quality", quality_plot(contenders, measured));
  return report.finish(checker);
}

}  // namespace regista::bench
