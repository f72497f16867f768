// `regista bench scale`: how planning's cost grows with obstacles, with a fleet, and in a crowd.
#pragma once

#include <string>
#include <vector>

#include "modules/bench/record.h"

namespace regista::bench {

struct ScaleOptions {
  std::size_t queries = 4000;         ///< per planner and number of obstacles
  std::size_t frames = 20;            ///< per planner and size of the fleet
  std::vector<std::string> planners;  ///< none: tangent, visibility_sampling and, but for fleets, rrt
  std::vector<std::size_t> obstacles{5, 10, 21, 50, 100, 200, 500, 1000};
  std::vector<std::size_t> robots{11, 22, 50, 100, 200, 500, 1000};
  std::vector<std::size_t> crowds{200, 300, 400};
  double for_s = 120.0;  ///< about how long it may take; what is slow gets fewer queries and frames
};

/// Returns the exit status. Throws UnknownPlanner.
int run_scale(const ScaleOptions& options, const Run& run);

}  // namespace regista::bench
