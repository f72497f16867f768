#include "modules/bench/motion/simple_drivers.h"

#include <algorithm>
#include <limits>

#include "control/motion_limits.h"

namespace regista::bench {
namespace {

constexpr double kHit_mps = 0.5;       // further from its last command a robot was hit; as the controller's default
constexpr double kBrakingShare = 0.9;  // the rest corrects errors
constexpr double kSettleTime_s = 0.1;  // slower than lag and delay together: no swinging around the target
constexpr double kSettleDistance_m = 0.002;

}  // namespace

TeamCommands VelocityDriver::drive(const FieldGeometry& /*field*/, const WorldState& world, const Targets& targets,
                                   double dt_s) {
  TeamCommands out{world.captured, team_, ++sequence_, world.sequence, {}};
  for (const RobotState& robot : world.robots) {
    if (robot.id.team != team_) continue;
    const auto target = std::find_if(targets.targets.begin(), targets.targets.end(),
                                     [&](const Target& one) { return one.robot == robot.id.number; });
    Vec2& told = told_mps_.try_emplace(robot.id.number, robot.twist.velocity_mps).first->second;
    if ((told - robot.twist.velocity_mps).norm() > kHit_mps) told = robot.twist.velocity_mps;
    told = clamped_norm(told, limits_.speed_max_mps);  // an estimate after a hit may be faster than a robot
    const Vec2 wanted = wanted_(robot, world, target == targets.targets.end() ? nullptr : &*target);
    told = limited_velocity(told, clamped_norm(wanted, limits_.speed_max_mps), limits_, dt_s);
    RobotCommand command;
    command.robot = robot.id.number;
    command.velocity = to_body({told, 0.0}, robot.pose.heading_rad);
    out.commands.push_back(command);
  }
  return out;
}

std::unique_ptr<Driver> straight_driver(Team team, const RobotLimits& limits) {
  const double braking = kBrakingShare * limits.braking_max_mps2;
  return std::make_unique<VelocityDriver>(
      team, limits, [braking](const RobotState& robot, const WorldState& /*world*/, const Target* target) -> Vec2 {
        if (target == nullptr) return Vec2::Zero();
        const Vec2 way = target->pose.position_m - robot.pose.position_m;
        const double distance_m = way.norm();
        if (distance_m < kSettleDistance_m) return Vec2::Zero();
        const double speed =
            std::min({target->speed_max_mps, std::sqrt(2.0 * braking * distance_m), distance_m / kSettleTime_s});
        return way * (speed / distance_m);
      });
}

std::unique_ptr<Driver> chaser(Team team, const RobotLimits& limits, double speed_mps) {
  return std::make_unique<VelocityDriver>(
      team, limits, [speed_mps](const RobotState& robot, const WorldState& world, const Target* /*target*/) -> Vec2 {
        double nearest_m = std::numeric_limits<double>::infinity();
        Vec2 way = Vec2::Zero();
        for (const RobotState& other : world.robots) {
          const Vec2 off = other.pose.position_m - robot.pose.position_m;
          if (other.id.team == robot.id.team || off.norm() >= nearest_m) continue;
          nearest_m = off.norm();
          way = off;
        }
        return nearest_m > 0.0 && way != Vec2::Zero() ? Vec2(way * (speed_mps / nearest_m)) : Vec2::Zero();
      });
}

}  // namespace regista::bench
