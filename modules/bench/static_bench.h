// `regista bench static`: every planner on 11 against 11 with defence areas and, half of the time, a ball placement.
#pragma once

#include <string>
#include <vector>

#include "modules/bench/contender.h"
#include "modules/bench/record.h"

namespace regista::bench {

/// Camera period of 100 Hz over a team of 11 (Pinheiro et al. 2020, eq. 2).
inline constexpr double kQueryBudget_us = 909.0;

struct StaticOptions {
  std::size_t queries = 10000;
  std::vector<std::string> planners;   ///< none: all of the registry
  double budget_us = kQueryBudget_us;  ///< per query, for planners that honour one; 0: none
  std::size_t batch = kBatch;
  double for_s = 120.0;  ///< about how long it may take; slow planners get every k-th query
};

/// Returns the exit status. Throws UnknownPlanner. Lengths are compared with `tangent`, or with the best of all
/// planners on that query where there is none.
int run_static(const StaticOptions& options, const Run& run);

}  // namespace regista::bench
