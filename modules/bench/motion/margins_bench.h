// `regista bench margins`: what margin between team-mates a robot needs that is not quite as its model says.
#pragma once

#include <string>
#include <vector>

#include "modules/bench/motion/loop_config.h"
#include "modules/bench/motion/seed_set.h"
#include "modules/bench/record.h"

namespace regista::bench {

struct MarginsOptions {
  double minutes = 5.0;  ///< simulated, per error and margin
  std::vector<double> margins_mm{0.0, 10.0, 20.0, 40.0};
  SystemChoice system;
  SeedSet seeds = SeedSet::tuning;
  std::size_t jobs = 2;
};

/// Returns the exit status. Throws ConfigError and UnknownPlanner.
int run_margins(const MarginsOptions& options, const Run& run);

}  // namespace regista::bench
