#include "modules/bench/paper/dvg_drives.h"

#include <fmt/core.h>

#include "modules/bench/paper/dvg_dynamic.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

constexpr double kMsPerUs = 1e-3;

void drive_once(const DynamicScenario& scenario, std::span<const double> phases, Entrant& entrant, std::uint64_t seed,
                DriveLog& log, Checker& checker) {
  double planning_us = 0.0;
  std::uint64_t plans = 0;
  const Drive result = drive(scenario, phases, [&](std::span<const dvg::Object> objects, const Vec2& from) {
    ObjectsQuery query{{objects.begin(), objects.end()}, from, scenario.goal};
    const Attempt attempt = entrant.plan(query, mixed(seed, plans++), 0.0);
    planning_us += attempt.time_us;
    entrant.check(query, attempt, checker);
    if (!attempt.reached) ++log.without_path;
    return attempt.reached ? attempt.path : std::vector<Vec2>{};
  });
  log.plans += plans;
  if (!result.arrived) {
    ++log.lost;
    return;
  }
  log.planning_ms.push_back(planning_us * kMsPerUs);
  log.recalculated.push_back(static_cast<double>(result.recalculated));
  log.navigation_s.push_back(result.navigation_s);
  log.collisions.push_back(static_cast<double>(result.collisions));
}

}  // namespace

std::vector<DriveLog> drive_all(std::size_t scenario_number, std::size_t drives, std::uint64_t seed, Checker& checker) {
  const DynamicScenario scenario = load_dynamic_scenario(kDynamicScenarios.at(scenario_number));
  Entrants entrants = dvg_and_rrt_and_ours();
  std::vector<DriveLog> logs(entrants.size());
  for (std::size_t k = 0; k < logs.size(); ++k) {
    logs[k].where = kDynamicScenarios.at(scenario_number);
    logs[k].who = entrants[k]->name();
  }
  Progress progress(scenario.title, drives);
  for (std::uint64_t i = 0; i < drives; ++i, progress.advance()) {
    std::mt19937_64 random(mixed(mixed(seed, scenario_number), i));
    std::vector<double> phases(scenario.obstacles.size());
    for (double& phase : phases) phase = uniform(random);
    for (const std::size_t k : rotated(entrants.size(), i)) {
      drive_once(scenario, phases, *entrants[k], mixed(random(), k), logs[k], checker);
    }
  }
  return logs;
}

std::vector<std::string> notes_of(const std::vector<DriveLog>& logs) {
  std::vector<std::string> notes;
  for (const char* name : kDynamicScenarios) {
    const auto is_of_it = [name](const DriveLog& log) { return log.where == name; };
    if (std::none_of(logs.begin(), logs.end(), is_of_it)) continue;
    notes.push_back(std::string("rebuilt, not tuned on results: ") + load_dynamic_scenario(name).rebuilt);
  }
  notes.emplace_back("ideal tracker, 2.5 m/s, 3 m/s² up, 4 m/s² down; bodies pass through each other");
  notes.emplace_back(
      "dvg and rrt as published (objects that cover the start reach only as far as there), of dvg only the ends of its "
      "paths are checked; the others leave such an object by the shortest way");
  for (const DriveLog& log : logs) {
    if (log.lost + log.without_path == 0) continue;
    notes.push_back(
        fmt::format("{}, {}: {} of {} plans gave no path (the robot brakes and asks again), {} drives did "
                    "not arrive within a minute",
                    log.where, log.who, log.without_path, log.plans, log.lost));
  }
  return notes;
}

}  // namespace regista::bench
