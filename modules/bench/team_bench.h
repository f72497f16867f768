// `regista bench team`: what the graph shared by a team is worth, against one query per robot from nothing.
#pragma once

#include <string>
#include <vector>

#include "modules/bench/record.h"

namespace regista::bench {

struct TeamOptions {
  std::size_t frames = 3000;
  std::vector<std::string> planners;  ///< none: those that use the shared graph
};

/// Returns the exit status; an answer that is not the same both ways is a fault. Throws UnknownPlanner.
int run_team(const TeamOptions& options, const Run& run);

}  // namespace regista::bench
