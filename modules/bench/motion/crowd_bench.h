// `regista bench crowd`: a team to random targets among another, in the closed loop: contacts, faults, pace and cost.
#pragma once

#include <string>
#include <vector>

#include "modules/bench/motion/loop_config.h"
#include "modules/bench/motion/seed_set.h"
#include "modules/bench/record.h"

namespace regista::bench {

struct CrowdOptions {
  double minutes = 10.0;  ///< simulated, per field, preset and opponents
  std::vector<std::string> presets{"none", "noisy", "realistic"};
  std::vector<std::string> fields{"A", "B"};                         ///< divisions
  std::vector<std::string> opponents{"system", "random", "chaser"};  ///< names of Opponents
  bool pass_through = true;                                          ///< the pace without others, to compare with
  SystemChoice system;
  SeedSet seeds = SeedSet::tuning;
  std::size_t jobs = 2;
};

/// Returns the exit status. Throws ConfigError, UnknownPlanner, std::invalid_argument.
int run_crowd(const CrowdOptions& options, const Run& run);

}  // namespace regista::bench
