// `regista bench ompl-grid`: the fastest setting of OMPL's planners that answers nearly always and nearly optimally,
// found in a committed grid, and how much faster the exact planner is in the same run.
#pragma once

#include <filesystem>

#include "modules/bench/contender.h"
#include "modules/bench/record.h"

namespace regista::bench {

struct GridOptions {
  std::size_t queries = 1000;
  std::filesystem::path grid;  ///< empty: the one shipped
  std::size_t batch = kBatch;
  double for_s = 300.0;  ///< about how long it may take; fewer queries then, and the table says how many
  double length_ratio_max = 1.01;
  double success_min = 0.999;
};

/// Returns the exit status. Throws std::runtime_error for a grid that makes no sense.
int run_ompl_grid(const GridOptions& options, const Run& run);

}  // namespace regista::bench
