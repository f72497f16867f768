// Success and length of several planners, each at several places of a curve (allowed time, samples per batch), on the
// same random scenes, interleaved.
#pragma once

#include "modules/bench/bench.h"
#include "modules/bench/paper/sampling_findings.h"
#include "modules/bench/paper/sbp_scenario.h"

namespace regista::bench {

/// One planner at one place of its curve, and what it did there.
struct SweepPoint {
  double x = 0.0;
  double budget_us = 0.0;
  Contender contender;
  std::vector<double> length_m = {}, length_ratio = {}, time_us = {};
  std::size_t failures = 0;
  std::size_t blocked = 0;         ///< scenes whose straight line is not free
  std::size_t blocked_solved = 0;  ///< of these
};

struct Sweep {
  std::string x_name, x_unit;
  std::vector<std::vector<SweepPoint>> curves;  ///< by planner, by place
};

/// `runs` scenes. Lengths are compared with those of the exact planner.
void measure(Sweep& sweep, const SbpScenario& scenario, std::size_t runs, const std::string& what, const Run& run,
             Checker& checker);

/// A row per planner and place.
Table table_of(const Sweep& sweep, const std::string& title);

/// "success", "success_blocked" (%), "length", "sigma" (m), "ratio", "ratio_sigma", "time" (us) by planner and place;
/// "half_success_at": the place from which on half of the blocked scenes succeed, by planner.
Measurement measurement_of(const Sweep& sweep);

/// Half the width of the 95 % confidence interval of a mean, of a standard deviation and of a share in percent, by the
/// normal approximation; 0 for fewer than two samples.
double confidence_of_mean(const Summary& summary);
double confidence_of_sigma(const Summary& summary);
double confidence_of_percent(double share, std::size_t count);

/// A plot of one of the quantities, with its confidence where it has one; planners are moved apart a little.
Plot plot_of(const Sweep& sweep, const std::string& title, const Axis& y, const std::string& quantity);

}  // namespace regista::bench
