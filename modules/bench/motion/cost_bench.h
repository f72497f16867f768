// `regista bench cost`: what a tick of a team of 11 among 22 costs: planning, all of control, and of it the safety
// search.
#pragma once

#include <string>
#include <vector>

#include "modules/bench/motion/loop_config.h"
#include "modules/bench/motion/seed_set.h"
#include "modules/bench/record.h"

namespace regista::bench {

struct CostOptions {
  double minutes = 2.0;                                          ///< simulated, per kind of safety search
  std::vector<std::string> safety{"none", "published", "team"};  ///< as controller.safety.mode, "none" first
  std::string preset = "noisy";                                  ///< of the simulator
  SystemChoice system;
  SeedSet seeds = SeedSet::tuning;
};

/// One game at a time, so that games do not take each other's caches. Returns the exit status. Throws ConfigError and
/// UnknownPlanner.
int run_cost(const CostOptions& options, const Run& run);

}  // namespace regista::bench
