// Who moves a team in a closed loop: the estimated world and the team's targets in, commands out.
#pragma once

#include <span>
#include <vector>

#include "control/velocity_command.h"
#include "planning/plan.h"
#include "world_model/types/field.h"
#include "world_model/types/world_state.h"

namespace regista::bench {

/// What one tick of a team took of its core, measured.
struct DriveTime {
  double planning_us = 0.0;
  double control_us = 0.0;
};

class Driver {
 public:
  Driver() = default;
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;
  virtual ~Driver() = default;

  /// The team's commands for that world; dt_s > 0 is the time since the last call. Deterministic: the same calls give
  /// the same commands.
  virtual TeamCommands drive(const FieldGeometry& field, const WorldState& world, const Targets& targets,
                             double dt_s) = 0;

  /// The plans of the last call; none where nothing is planned.
  virtual std::span<const RobotPlan> plans() const { return {}; }
  /// One per call; none where nothing is measured.
  virtual std::span<const DriveTime> times() const { return {}; }
};

}  // namespace regista::bench
