// `regista bench motion`: how far from the least time a robot is that nobody moves against: alone from random states,
// and among robots that stand.
#pragma once

#include <string>
#include <vector>

#include "modules/bench/motion/loop_config.h"
#include "modules/bench/motion/seed_set.h"
#include "modules/bench/record.h"

namespace regista::bench {

struct MotionOptions {
  std::size_t moves = 1000;  ///< free ones, per set of limits
  std::size_t drives = 100;  ///< among standing robots, per preset
  std::vector<std::string> presets{"none", "noisy"};
  SystemChoice system;
  SeedSet seeds = SeedSet::tuning;
  std::size_t jobs = 2;
};

/// Returns the exit status. Throws ConfigError and UnknownPlanner.
int run_motion(const MotionOptions& options, const Run& run);

}  // namespace regista::bench
