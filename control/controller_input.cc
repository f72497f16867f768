#include "control/controller_input.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace regista {
namespace {

void require_finite(double value, RobotId robot, const char* what) {
  if (std::isfinite(value)) return;
  throw std::invalid_argument("Controller: " + std::string(what) + " of " + to_string(robot) + " is " +
                              std::to_string(value));
}

void require_finite(const Vec2& value, RobotId robot, const char* what) {
  require_finite(value.x(), robot, what);
  require_finite(value.y(), robot, what);
}

void check(const RobotState& robot) {
  require_finite(robot.pose.position_m, robot.id, "position");
  require_finite(robot.pose.heading_rad, robot.id, "heading");
  require_finite(robot.twist.velocity_mps, robot.id, "velocity");
  require_finite(robot.twist.angular_radps, robot.id, "turning rate");
}

void check(const RobotPlan& plan) {
  for (const Vec2& point : plan.plan.path) require_finite(point, plan.robot, "path");
  require_finite(plan.target.pose.heading_rad, plan.robot, "target heading");
  require_finite(plan.target.speed_max_mps, plan.robot, "target speed limit");
}

}  // namespace

void require_finite(const WorldState& world) {
  for (const RobotState& robot : world.robots) check(robot);
}

double checked_period_s(double dt_s, double period_max_s) {
  if (!(dt_s > 0.0) || !std::isfinite(dt_s)) {
    throw std::invalid_argument("Controller: dt_s must be positive and finite, is " + std::to_string(dt_s));
  }
  return std::min(dt_s, period_max_s);
}

PlansByRobot plans_of(Team team, std::span<const RobotPlan> plans) {
  PlansByRobot by_robot;
  for (const RobotPlan& plan : plans) {
    check(plan);
    if (plan.robot.team == team && !by_robot.emplace(plan.robot.number, &plan).second) {
      throw std::invalid_argument("Controller: two plans for " + to_string(plan.robot));
    }
  }
  return by_robot;
}

}  // namespace regista
