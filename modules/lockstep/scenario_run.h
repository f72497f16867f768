// The main job: a scenario in lock step from beginning to end, judged and summed up; its messages go to an LCM log.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "modules/lockstep/side_changes.h"
#include "modules/process/config.h"
#include "modules/process/percentiles.h"
#include "modules/process/real_clock.h"
#include "sim/validators.h"

namespace regista {

struct RunSummary {
  Scenario scenario;
  double simulated_s = 0.0;
  double wall_s = 0.0;
  std::int64_t reached_yellow = 0;
  std::int64_t reached_blue = 0;
  ContactCounts contacts;
  SideChangeRate side_changes_yellow;
  SideChangeRate side_changes_blue;
  Percentiles robot_planning;  ///< one robot's plan
  Percentiles team_planning;   ///< a team's tick of the planner, graph included
  Percentiles frame;           ///< from one vision frame to the next, everything included
  std::vector<Violation> violations;
};

struct RunOptions {
  std::string log_file;  ///< empty: no log. Holds every message but TIMING.* and STATUS.*: same seed, same bytes
  std::function<void(double simulated_s, const RunSummary& so_far)> on_progress = {};  ///< once per simulated second
  std::function<bool()> stopped = {};  ///< asked once per frame; true ends the run early
};

/// Throws ConfigError on a bad configuration, LogError when the log cannot be written.
RunSummary run_scenario(const Config& config, const RunOptions& options, const Stopwatch& stopwatch);

/// The summary as the table people read.
std::string to_table(const RunSummary& summary);

}  // namespace regista
