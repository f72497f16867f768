// One drive of the dynamic test of Costa & Tonidandel (section 5) in the closed loop: the robot is driven by the
// system, the obstacles are robots that go to and fro as fast as they can and know nothing of it.
#pragma once

#include <span>
#include <string>

#include "modules/bench/motion/loop_config.h"
#include "modules/bench/paper/dvg_dynamic.h"

namespace regista::bench {

struct DynamicDrive {
  bool arrived = false;        ///< within a minute
  double planning_ms = 0.0;    ///< of all plans
  std::size_t crossed = 0;     ///< frames that found an obstacle's centre within 90 mm of the path of the frame before
  double navigation_s = 0.0;   ///< until within 1 cm of the goal and slower than 0.3 m/s
  double straight_s = 0.0;     ///< the least time of the straight line, at the scenario's top speed
  std::size_t collisions = 0;  ///< centres nearer than 180 mm; one counts only 0.5 s after the one before, as printed
  LoopVerdict verdict = {};
  std::size_t at_fault = 0;  ///< of these, the robot's alone or shared guilt by the crash rule
};

/// `phases` are shares of each obstacle's time there and back. Bodies pass through each other. Obstacles are robots
/// like ours: they speed up and brake within its limits, up to its top speed (at least 2.4 of 2.5 m/s where they cross
/// the straight line); those of bench paper turn round at full speed. Throws ConfigError and UnknownPlanner.
DynamicDrive drive_dynamic(const DynamicScenario& scenario, std::span<const double> phases, const SystemChoice& system,
                           const std::string& preset, std::uint64_t seed);

}  // namespace regista::bench
