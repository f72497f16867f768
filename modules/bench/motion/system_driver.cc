#include "modules/bench/motion/system_driver.h"

#include <algorithm>

#include "modules/bench/motion/cpu_time.h"

namespace regista::bench {

SystemDriver::SystemDriver(Team team, const SystemParams& params)
    : team_(team),
      planner_(team, params.planning),
      controller_(team, params.control),
      radius_m_(params.control.limits.radius_m) {
  planner_.use(params.planner);
}

TeamCommands SystemDriver::drive(const FieldGeometry& field, const WorldState& world, const Targets& targets,
                                 double dt_s) {
  const CpuShot planning;
  plans_ = planner_.plan(field, world, targets).plans;  // without stopwatch: no time limit, so deterministic
  const double planning_us = planning.us();
  const CpuShot control;
  TeamCommands commands =
      controller_.update(world, plans_, dt_s, surroundings_of(team_, field, world, Situation{}, radius_m_));
  times_.push_back({planning_us, control.us()});
  return commands;
}

TeamCommands PassThroughDriver::drive(const FieldGeometry& field, const WorldState& world, const Targets& targets,
                                      double dt_s) {
  TeamCommands all;
  all.team = team_;
  all.captured = world.captured;
  all.world_sequence = world.sequence;
  for (const RobotState& robot : world.robots) {
    if (robot.id.team != team_) continue;
    WorldState alone = world;
    alone.robots = {robot};
    Targets own = targets;
    std::erase_if(own.targets, [&](const Target& target) { return target.robot != robot.id.number; });
    std::unique_ptr<SystemDriver>& driver = robots_[robot.id.number];
    if (driver == nullptr) driver = std::make_unique<SystemDriver>(team_, params_);
    const TeamCommands commands = driver->drive(field, alone, own, dt_s);
    all.sequence = commands.sequence;
    all.commands.insert(all.commands.end(), commands.commands.begin(), commands.commands.end());
  }
  return all;
}

}  // namespace regista::bench
