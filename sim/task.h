// What a team is told to do in a scenario, whichever task it is: world in, targets out.
#pragma once

#include <variant>

#include "sim/random_targets.h"
#include "sim/scenario.h"
#include "world_model/types/robot_limits.h"

namespace regista {

/// Every robot stays where it was first seen.
class StandTargets {
 public:
  StandTargets(Team team, const FieldGeometry& field);

  /// sequence and captured change only when a robot is seen for the first time.
  const Targets& update(const WorldState& world);

 private:
  FieldGeometry field_;
  Targets targets_;
};

using Task = std::variant<StandTargets, RandomTargets>;

/// The scenario's task for one team; the teams' random numbers are independent. Throws as validate(scenario).
Task make_task(const Scenario& scenario, Team team);

/// The team's targets for that world; valid until the next call.
const Targets& update(Task& task, const WorldState& world);

/// Targets reached so far; a task without such counts 0.
std::int64_t reached(const Task& task);

}  // namespace regista
