// `regista bench anytime`: success and length of sampling planners against the time they are allowed (the kind of
// figures of Pinheiro, Maximo & Yoneyama, LARS 2020, on 11 against 11).
#pragma once

#include <string>
#include <vector>

#include "modules/bench/record.h"

namespace regista::bench {

struct AnytimeOptions {
  std::size_t queries = 200;  ///< per planner and time; queries whose straight line is blocked and that have a way
  std::vector<std::string> planners;  ///< none: those of OMPL that are there; tangent is always beside them
  std::vector<double> times_ms{0.1, 0.2, 0.3, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0};
};

/// Returns the exit status. Throws UnknownPlanner.
int run_anytime(const AnytimeOptions& options, const Run& run);

}  // namespace regista::bench
