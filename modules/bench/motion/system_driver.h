// The system as a driver: planner and controller, as their modules use them. The one place where benches of motion call
// the controller.
#pragma once

#include <map>
#include <memory>

#include "control/controller.h"
#include "modules/bench/motion/driver.h"
#include "planning/team_planner.h"

namespace regista::bench {

struct SystemParams {
  std::string planner{kDefaultPlanner};
  PlanningParams planning;
  ControlParams control;
};

class SystemDriver : public Driver {
 public:
  /// Throws UnknownPlanner, and std::invalid_argument as Controller does.
  SystemDriver(Team team, const SystemParams& params);

  TeamCommands drive(const FieldGeometry& field, const WorldState& world, const Targets& targets, double dt_s) override;
  std::span<const RobotPlan> plans() const override { return plans_; }
  std::span<const DriveTime> times() const override { return times_; }

 private:
  Team team_;
  TeamPlanner planner_;
  Controller controller_;
  double radius_m_;
  std::vector<RobotPlan> plans_;
  std::vector<DriveTime> times_;
};

/// The system where robots are nothing to each other: each has a planner and a controller that see it alone. What it
/// reaches on a field where bodies do not collide is what avoiding others costs nothing of.
class PassThroughDriver : public Driver {
 public:
  PassThroughDriver(Team team, const SystemParams& params) : team_(team), params_(params) {}

  TeamCommands drive(const FieldGeometry& field, const WorldState& world, const Targets& targets, double dt_s) override;

 private:
  Team team_;
  SystemParams params_;
  std::map<std::uint16_t, std::unique_ptr<SystemDriver>> robots_;
};

}  // namespace regista::bench
