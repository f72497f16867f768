#include "modules/bench/paper/sbp_figures.h"

#include "modules/bench/paper/sbp_sweep.h"

namespace regista::bench {
namespace {

Sweep sweep_of_batches(const DataTable& figure, double budget_us) {
  Sweep sweep{"samples per batch", "", {}};
  for (const DataTable& row : figure.tables("planner")) {
    sweep.curves.emplace_back();
    for (const double samples : figure.numbers("samples_per_batch")) {
      PlanningParams params;
      params.ompl.samples_per_batch = static_cast<std::int64_t>(samples);
      sweep.curves.back().push_back({samples, budget_us, contender_of(row, params)});
    }
  }
  return sweep;
}

Sweep sweep_of_times(const DataTable& figure) {
  Sweep sweep{"allowed time", "ms", {}};
  for (const DataTable& row : figure.tables("planner")) {
    sweep.curves.emplace_back();
    for (const double time_ms : figure.numbers("times_ms")) {
      sweep.curves.back().push_back({time_ms, 1e3 * time_ms, contender_of(row)});
    }
  }
  return sweep;
}

Axis success_axis() { return {"success", "%", false, 0.0, 105.0}; }

}  // namespace

int run_sbp_batches(const PaperOptions& options, const Run& run) {
  const DataTable data(kSbpFile);
  const DataTable figure = data.table("batches");
  const double budget_us = options.budget_us > 0.0 ? options.budget_us : sbp_budget_us(data);
  Sweep sweep = sweep_of_batches(figure, budget_us);
  Report report(run);
  Checker checker;
  measure(sweep, sbp_scenario(data), runs_or(options.samples, figure), "sbp-figures6-9", run, checker);
  report.add("sbp-figures6-9",
             table_of(sweep, "Pinheiro et al., figures 6 and 9: success, and sigma of the length, against samples"));
  report.add("sbp-figures6-9_findings", findings_table("Pinheiro et al., figures 6 and 9: what the text says",
                                                       figure.tables("finding"), measurement_of(sweep)));
  report.add("sbp-figure6",
             plot_of(sweep, "Pinheiro et al., figure 6: success within 1/(5 FPS)", success_axis(), "success_blocked"));
  report.add("sbp-figure9", plot_of(sweep, "Pinheiro et al., figure 9: standard deviation of the length",
                                    {"sigma of length / optimum"}, "ratio_sigma"));
  return report.finish(checker);
}

int run_sbp_times(const PaperOptions& options, const Run& run) {
  const DataTable data(kSbpFile);
  const DataTable figure = data.table("times");
  Sweep sweep = sweep_of_times(figure);
  Report report(run);
  Checker checker;
  measure(sweep, sbp_scenario(data), runs_or(options.samples, figure), "sbp-figures7-8", run, checker);
  report.add("sbp-figures7-8",
             table_of(sweep, "Pinheiro et al., figures 7 and 8: success and length against allowed time"));
  report.add("sbp-figures7-8_findings", findings_table("Pinheiro et al., figures 7 and 8: what the text says",
                                                       figure.tables("finding"), measurement_of(sweep)));
  report.add("sbp-figure7", plot_of(sweep, "Pinheiro et al., figure 7: success where the straight line is blocked",
                                    success_axis(), "success_blocked"));
  report.add("sbp-figure8",
             plot_of(sweep, "Pinheiro et al., figure 8: mean length of the paths found", {"length", "m"}, "length"));
  report.add("sbp-figure8_ratio",
             plot_of(sweep, "Pinheiro et al., figure 8 without the scenes' own spread: length over the shortest",
                     {"length / shortest"}, "ratio"));
  return report.finish(checker);
}

}  // namespace regista::bench
