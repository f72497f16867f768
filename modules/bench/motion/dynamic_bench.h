// `regista bench dynamic`: tables 8 to 11 of Costa & Tonidandel with the system driving, for planners and kinds of
// safety search.
#pragma once

#include <string>
#include <vector>

#include "modules/bench/motion/loop_config.h"
#include "modules/bench/motion/seed_set.h"
#include "modules/bench/record.h"

namespace regista::bench {

struct DynamicOptions {
  std::size_t drives = 200;  ///< per scenario, preset, planner and safety; the paper's number
  std::vector<std::string> planners{"dvg", "rrt", "visibility_sampling", "tangent"};
  std::vector<std::string> safety{"none", "published", "team"};  ///< as controller.safety.mode
  std::vector<std::string> presets{"none", "noisy"};
  std::vector<std::string> settings;  ///< as SystemChoice has them
  SeedSet seeds = SeedSet::tuning;
  std::size_t jobs = 2;
};

/// Returns the exit status. Throws ConfigError and UnknownPlanner.
int run_dynamic(const DynamicOptions& options, const Run& run);

}  // namespace regista::bench
