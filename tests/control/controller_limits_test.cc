// The controller's commands never exceed the limits and never jump, whatever worlds, plans and parameters come and go.
#include <rapidcheck.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "control/controller.h"
#include "tests/control/ideal_team.h"

namespace regista {
namespace {

using test::Dice;
using test::plan_along;
using test::random_world;
using test::robot_at;
using test::step;

constexpr double kDt_s = 0.01;
constexpr double kRounding = 1e-9;

/// Any plan: good, pointless, backwards, invalid, or for nobody.
RobotPlan random_plan(Dice& dice, std::uint16_t robot) {
  std::vector<Vec2> path;
  const int points = static_cast<int>(dice.uniform(0.0, 7.0));
  for (int i = 0; i < points; ++i) {
    path.push_back(dice.uniform(0, 1) < 0.2 && i > 0 ? path.back() : dice.point(6.0, 4.5));
  }
  RobotPlan plan = plan_along(robot, path, dice.uniform(-10.0, 10.0));
  plan.target.speed_max_mps = dice.uniform(0.0, 1.0) < 0.2 ? 0.0 : dice.uniform(0.0, 5.0);
  plan.plan.status = static_cast<PlanStatus>(static_cast<int>(dice.uniform(0.0, 4.0)));
  return plan;
}

std::vector<RobotPlan> random_plans(Dice& dice, int robots) {
  std::vector<RobotPlan> plans;
  for (int i = 0; i < robots; ++i) {
    if (dice.uniform(0.0, 1.0) < 0.8) plans.push_back(random_plan(dice, static_cast<std::uint16_t>(i)));
  }
  return plans;
}

void require_within_limits(const TeamCommands& commands, const ControlParams& params) {
  for (const RobotCommand& command : commands.commands) {
    const double speed = std::hypot(command.velocity.forward_mps, command.velocity.left_mps);
    REQUIRE(speed <= params.limits.speed_max_mps + kRounding);
    REQUIRE(std::abs(command.velocity.angular_radps) <= params.limits.angular_speed_max_radps + kRounding);
    const WheelSpeeds wheels = OmniWheels(params.wheels).speeds(command.velocity);
    for (std::size_t i = 0; i < 4; ++i) {
      REQUIRE(command.wheel_speeds_radps[i] == Approx(wheels[i]).margin(1e-9));
      REQUIRE(std::abs(command.wheel_speeds_radps[i]) <= params.wheels.wheel_speed_max_radps + 1e-6);
    }
  }
}

/// The change between two commands, field frame, against the limits.
void require_no_jump(const Twist& before, const Twist& after, const RobotLimits& limits) {
  const double change = (after.velocity_mps - before.velocity_mps).norm();
  const double faster = after.velocity_mps.norm() - before.velocity_mps.norm();
  REQUIRE(change <= std::max(limits.acceleration_max_mps2, limits.braking_max_mps2) * kDt_s + kRounding);
  REQUIRE(faster <= limits.acceleration_max_mps2 * kDt_s + kRounding);
  REQUIRE(std::abs(after.angular_radps - before.angular_radps) <=
          limits.angular_acceleration_max_radps2 * kDt_s + kRounding);
}

TEST_CASE("never above the limits, for any world and any plans") {
  REQUIRE(rc::check("limits", [](std::uint64_t seed) {
    Dice dice(seed);
    ControlParams params;
    if (dice.uniform(0, 1) < 0.3) params.wheels.wheel_speed_max_radps = dice.uniform(10.0, 100.0);
    Controller controller(Team::yellow, params);
    for (int tick = 0; tick < 10; ++tick) {
      const WorldState world = random_world(dice, 5, 20.0);
      require_within_limits(controller.update(world, random_plans(dice, 6), dice.uniform(0.001, 0.2)), params);
    }
  }));
}

TEST_CASE("no command jumps, whatever plans come and go") {
  REQUIRE(rc::check("no jump", [](std::uint64_t seed) {
    Dice dice(seed);
    const ControlParams params;
    Controller controller(Team::yellow, params);
    WorldState world = random_world(dice, 4, 2.9);
    std::vector<RobotPlan> plans;
    for (int tick = 0; tick < 60; ++tick) {
      const WorldState before = world;
      // Plans are kept for a while so that speed builds up, then all change at once, now and then all are lost.
      if (tick % 12 == 0) plans = random_plans(dice, 4);
      const bool blind = dice.uniform(0, 1) < 0.1;
      const TeamCommands commands = blind ? controller.brake(&world, kDt_s) : controller.update(world, plans, kDt_s);
      step(world, commands, kDt_s);
      if (blind && tick == 0) continue;  // nobody was commanded yet
      for (std::size_t i = 0; i < world.robots.size(); ++i) {
        require_no_jump(before.robots[i].twist, world.robots[i].twist, params.limits);
      }
    }
  }));
}

TEST_CASE("a planner's change of path in full motion does not make the command jump") {
  Controller controller(Team::yellow, {});
  WorldState world;
  world.robots = {robot_at(3, {0, 0})};
  Twist before;
  for (int tick = 0; tick < 200; ++tick) {
    RobotPlan plan = plan_along(3, tick < 100 ? std::vector<Vec2>{{0, 0}, {6, 0}} : std::vector<Vec2>{{0, 0}, {0, -4}});
    plan.generation = tick < 100 ? 1 : 2;
    step(world, controller.update(world, std::vector{plan}, kDt_s), kDt_s);
    require_no_jump(before, world.robots[0].twist, {});
    before = world.robots[0].twist;
    if (tick == 99) CHECK(before.velocity_mps.norm() > 2.5);
  }
}

TEST_CASE("new parameters take effect without a jump, and the target's own speed limit is kept") {
  Controller controller(Team::yellow, {});
  WorldState world;
  world.robots = {robot_at(0, {-5, 0})};
  std::vector<RobotPlan> plans{plan_along(0, {{-5, 0}, {5, 0}})};
  for (int tick = 0; tick < 120; ++tick) step(world, controller.update(world, plans, kDt_s), kDt_s);
  CHECK(world.robots[0].twist.velocity_mps.x() == Approx(3.0));
  ControlParams slower;
  slower.limits.speed_max_mps = 1.5;
  controller.set_params(slower);
  Twist before = world.robots[0].twist;
  for (int tick = 0; tick < 60; ++tick) {
    step(world, controller.update(world, plans, kDt_s), kDt_s);
    require_no_jump(before, world.robots[0].twist, slower.limits);
    before = world.robots[0].twist;
  }
  CHECK(before.velocity_mps.x() == Approx(1.5));
  plans[0].target.speed_max_mps = 0.4;
  for (int tick = 0; tick < 60; ++tick) step(world, controller.update(world, plans, kDt_s), kDt_s);
  CHECK(world.robots[0].twist.velocity_mps.x() == Approx(0.4));
}

TEST_CASE("a wheel limit slows all wheels so that the direction is kept") {
  ControlParams params;
  params.wheels.wheel_speed_max_radps = 40.0;
  Controller controller(Team::yellow, params);
  WorldState world;
  world.robots = {robot_at(0, {0, 0}, 0.4)};
  const std::vector<RobotPlan> plans{plan_along(0, {{0, 0}, {4, 3}}, 0.4)};
  for (int tick = 0; tick < 80; ++tick) step(world, controller.update(world, plans, kDt_s), kDt_s);
  const Vec2 velocity = world.robots[0].twist.velocity_mps;
  CHECK(velocity.norm() > 1.0);
  // The bang-bang drive divides the limits between its axes to 0.1°.
  CHECK(cross(velocity, Vec2(0.8, 0.6)) == Approx(0.0).margin(1e-3 * velocity.norm()));
}

}  // namespace
}  // namespace regista
