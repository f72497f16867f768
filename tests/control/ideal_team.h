// The smallest field there is, for the tests of control: robots that move exactly as they are told. Velocity is the
// command, held in the body for the period, so a moving robot that turns drives an arc.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "control/controller.h"
#include "control/path_legs.h"

namespace regista::test {

/// Reproducible anywhere: raw bits of the generator, mapped by hand.
struct Dice {
  std::mt19937_64 bits;
  explicit Dice(std::uint64_t seed) : bits(seed) {}
  double uniform(double low, double high) { return low + (high - low) * static_cast<double>(bits() >> 11U) * 0x1p-53; }
  Vec2 point(double half_x, double half_y) {
    const double x = uniform(-half_x, half_x);
    return {x, uniform(-half_y, half_y)};
  }
  Vec2 direction() { return rotated({1.0, 0.0}, uniform(-std::numbers::pi, std::numbers::pi)); }
  double normal() {
    return std::sqrt(-2.0 * std::log(uniform(1e-12, 1.0))) * std::cos(uniform(0.0, 6.283185307179586));
  }
};

inline RobotState robot_at(std::uint16_t number, const Vec2& position_m, double heading_rad = 0.0,
                           const Twist& twist = {}, Team team = Team::yellow) {
  RobotState robot;
  robot.id = {team, number};
  robot.pose = {position_m, heading_rad};
  robot.twist = twist;
  return robot;
}

inline RobotPlan plan_along(std::uint16_t number, std::vector<Vec2> path, double heading_rad = 0.0,
                            Team team = Team::yellow) {
  RobotPlan plan;
  plan.robot = {team, number};
  plan.target.robot = number;
  plan.target.pose = {path.empty() ? Vec2::Zero() : path.back(), heading_rad};
  plan.target.speed_max_mps = 100.0;
  plan.plan.status = PlanStatus::ok;
  plan.plan.path = std::move(path);
  return plan;
}

/// Yellow robots anywhere, at up to that speed.
inline WorldState random_world(Dice& dice, int robots, double speed_max) {
  WorldState world;
  for (int i = 0; i < robots; ++i) {
    const Twist twist{dice.direction() * dice.uniform(0.0, speed_max), dice.uniform(-speed_max, speed_max)};
    world.robots.push_back(
        robot_at(static_cast<std::uint16_t>(i), dice.point(6.0, 4.5), dice.uniform(-3.1, 3.1), twist));
  }
  return world;
}

/// The command in the field frame, as the mean of the period it is held for.
inline Twist field_twist(const RobotCommand& command, double heading_rad, double dt_s) {
  return to_field(command.velocity, heading_rad + command.velocity.angular_radps * dt_s / 2.0);
}

/// Moves every robot of the world that has a command, as it is told, and counts the world's sequence up.
inline void step(WorldState& world, const TeamCommands& commands, double dt_s) {
  for (const RobotCommand& command : commands.commands) {
    for (RobotState& robot : world.robots) {
      if (robot.id != RobotId{commands.team, command.robot}) continue;
      robot.twist = field_twist(command, robot.pose.heading_rad, dt_s);
      robot.pose.position_m += robot.twist.velocity_mps * dt_s;
      robot.pose.heading_rad = wrap_angle(robot.pose.heading_rad + robot.twist.angular_radps * dt_s);
    }
  }
  ++world.sequence;
}

/// What a planner answers that is asked again on the way: the path from the position on, without the vertices passed.
inline std::vector<Vec2> from_here(const std::vector<Vec2>& path, const Vec2& position) {
  std::vector<Vec2> ahead{position};
  for (std::size_t i = nearest_leg(path, position) + 1; i < path.size(); ++i) ahead.push_back(path[i]);
  if (path.size() == 1) ahead.push_back(path[0]);
  return ahead;
}

/// Distance from a point to a polyline.
inline double distance_to(const std::vector<Vec2>& path, const Vec2& point) {
  double distance = (point - path.front()).norm();
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    distance = std::min(distance, (point - nearest_on_segment(point, path[i], path[i + 1])).norm());
  }
  return distance;
}

}  // namespace regista::test
