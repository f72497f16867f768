// What the tests of the whole loop share: scenarios, running on, and how fast a team is.
#pragma once

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "modules/lockstep/scenario_run.h"
#include "modules/lockstep/whole_loop.h"

namespace regista::loop_test {

inline const std::string kCrossing = std::string(REGISTA_SOURCE_DIR) + "/modules/scenarios/crossing.toml";
inline constexpr double kPeriod_s = 0.01;  // of vision

inline std::int64_t no_time() { return 0; }

inline Config crossing(const std::vector<std::string>& settings) { return Config::load(kCrossing, settings); }

/// A few robots: they rarely meet, so that what is seen is the modules' doing and no collision's.
inline Config few_robots() {
  return crossing({"scenario.robots_per_team=2", "scenario.sim_preset=none", "scenario.seed=3"});
}

inline std::string bytes_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void run_for(LockStep& loop, double seconds) { loop.run_until(loop.now() + from_seconds(seconds)); }

inline double fastest_mps(const WholeLoop& modules, Team team) {
  double fastest = 0.0;
  for (const RobotState& robot : modules.sim->simulator().truth().robots) {
    if (robot.id.team == team) fastest = std::max(fastest, robot.twist.velocity_mps.norm());
  }
  return fastest;
}

/// The fastest any robot of the team goes at some moment of that time.
inline double fastest_during_mps(LockStep& loop, const WholeLoop& modules, Team team, double seconds) {
  double fastest = 0.0;
  for (double t = 0.0; t < seconds; t += kPeriod_s) {
    run_for(loop, kPeriod_s);
    fastest = std::max(fastest, fastest_mps(modules, team));
  }
  return fastest;
}

// From 3 m/s at 4 m/s², after the longest deadline on the way (targets: 1 s).
inline constexpr double kStopsWithin_s = 1.0 + 3.0 / 4.0 + 0.5;

}  // namespace regista::loop_test
