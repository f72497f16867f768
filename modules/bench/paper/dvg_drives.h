// The dynamic test of Costa & Tonidandel, measured: all drives of all planners.
#pragma once

#include <array>

#include "modules/bench/paper/dvg_static.h"

namespace regista::bench {

inline constexpr std::array kDynamicScenarios{"dvg_dynamic_1", "dvg_dynamic_2"};

/// All drives of one planner in one scenario.
struct DriveLog {
  std::string where, who;
  std::vector<double> planning_ms, recalculated, navigation_s, collisions;  ///< one value per drive that arrived
  std::size_t lost = 0;                                                     ///< drives that did not
  std::size_t plans = 0;                                                    ///< asked for
  std::size_t without_path = 0;                                             ///< of these
};

/// One log per planner. Every planner meets the same obstacles: where they begin comes from seed, scenario and drive.
std::vector<DriveLog> drive_all(std::size_t scenario_number, std::size_t drives, std::uint64_t seed, Checker& checker);

/// What was rebuilt, and which plans and drives failed.
std::vector<std::string> notes_of(const std::vector<DriveLog>& logs);

}  // namespace regista::bench
