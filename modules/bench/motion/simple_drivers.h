// Drivers that know nothing of the system under test, for opponents: each robot has a velocity it wants and changes to
// it as fast as its body can.
#pragma once

#include <functional>
#include <map>
#include <memory>

#include "modules/bench/motion/driver.h"
#include "world_model/types/robot_limits.h"

namespace regista::bench {

/// The velocity, field frame, that a robot wants. The target is nullptr where it has none.
using WantedVelocity = std::function<Vec2(const RobotState& robot, const WorldState& world, const Target* target)>;

/// Headings stay. A robot that is elsewhere than its last command says (it was hit) is picked up where it is.
class VelocityDriver : public Driver {
 public:
  VelocityDriver(Team team, const RobotLimits& limits, WantedVelocity wanted)
      : team_(team), limits_(limits), wanted_(std::move(wanted)) {}

  TeamCommands drive(const FieldGeometry& field, const WorldState& world, const Targets& targets, double dt_s) override;

 private:
  Team team_;
  RobotLimits limits_;
  WantedVelocity wanted_;
  std::uint64_t sequence_ = 0;
  std::map<std::uint16_t, Vec2> told_mps_;
};

/// Straight to the target and to rest there, no faster than the target says; avoids nobody.
std::unique_ptr<Driver> straight_driver(Team team, const RobotLimits& limits);

/// At full speed towards the nearest robot of the other team.
std::unique_ptr<Driver> chaser(Team team, const RobotLimits& limits, double speed_mps);

}  // namespace regista::bench
