// One robot's drive across the field among 21 that stand, for the bench of free motion.
#pragma once

#include <optional>

#include "modules/bench/motion/loop_config.h"

namespace regista::bench {

struct StandingDrive {
  double ideal_s = 0.0;             ///< along the exact path's length: rest to rest, limits of the straight line
  std::optional<double> arrived_s;  ///< from the first plan until within 1 cm and nearly at rest; none within 20 s
  std::int64_t contacts = 0;
  LoopVerdict verdict = {};
};

/// Robots stand anywhere outside the defence areas of division A with gaps that a robot fits through or none; start and
/// target at least 3 m apart. Throws ConfigError and UnknownPlanner.
StandingDrive drive_among_standing(const SystemChoice& system, const std::string& preset, std::uint64_t seed);

}  // namespace regista::bench
