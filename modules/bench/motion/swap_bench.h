// `regista bench swap`: set pieces in which robots are in each other's way, from circles that swap to a target that is
// occupied.
#pragma once

#include <string>
#include <vector>

#include "modules/bench/motion/loop_config.h"
#include "modules/bench/motion/seed_set.h"
#include "modules/bench/record.h"

namespace regista::bench {

struct SwapOptions {
  std::size_t runs = 5;             ///< per scene
  std::string preset = "noisy";     ///< of the simulator
  std::vector<std::string> scenes;  ///< words of their names; none: all
  SystemChoice system;
  SeedSet seeds = SeedSet::tuning;
  std::size_t jobs = 2;
  bool pictures = true;  ///< draw the swap of 22 through regista-viewer
};

/// Returns the exit status. The first run of every scene is recorded to <out>/swap_<n>.lcmlog. Throws ConfigError,
/// UnknownPlanner, and std::invalid_argument where no scene has such a name.
int run_swap(const SwapOptions& options, const Run& run);

}  // namespace regista::bench
