// The controller's commands: for whom, from what, with what memory, and what is refused. Robots obey at once.
#include "control/controller.h"

#include <catch2/catch.hpp>
#include <limits>
#include <stdexcept>

#include "tests/control/ideal_team.h"

namespace regista {
namespace {

using test::Dice;
using test::plan_along;
using test::random_world;
using test::robot_at;
using test::step;

constexpr double kDt_s = 0.01;

TEST_CASE("mirrored world and plans give mirrored commands") {
  Dice dice(41);
  const auto mirrored = [](const Vec2& v) { return Vec2(v.x(), -v.y()); };
  for (int run = 0; run < 50; ++run) {
    Controller controller(Team::yellow, {});
    Controller twin(Team::yellow, {});
    WorldState world = random_world(dice, 3, 2.0);
    std::vector<RobotPlan> plans;
    for (std::uint16_t i = 0; i < 3; ++i) {
      plans.push_back(plan_along(i, {dice.point(3, 3), dice.point(3, 3), dice.point(3, 3)}, dice.uniform(-3, 3)));
    }
    WorldState other = world;
    std::vector<RobotPlan> other_plans = plans;
    for (RobotState& robot : other.robots) {
      robot.pose = {mirrored(robot.pose.position_m), -robot.pose.heading_rad};
      robot.twist = {mirrored(robot.twist.velocity_mps), -robot.twist.angular_radps};
    }
    for (RobotPlan& plan : other_plans) {
      for (Vec2& point : plan.plan.path) point = mirrored(point);
      plan.target.pose = {mirrored(plan.target.pose.position_m), -plan.target.pose.heading_rad};
    }
    for (int tick = 0; tick < 50; ++tick) {
      const TeamCommands a = controller.update(world, plans, kDt_s);
      const TeamCommands b = twin.update(other, other_plans, kDt_s);
      for (std::size_t i = 0; i < 3; ++i) {
        const RobotCommand& left = a.commands[i];
        const RobotCommand& right = b.commands[i];
        REQUIRE(left.velocity.forward_mps == Approx(right.velocity.forward_mps).margin(1e-6));
        REQUIRE(left.velocity.left_mps == Approx(-right.velocity.left_mps).margin(1e-6));
        REQUIRE(left.velocity.angular_radps == Approx(-right.velocity.angular_radps).margin(1e-6));
        REQUIRE(left.wheel_speeds_radps[0] == Approx(-right.wheel_speeds_radps[3]).margin(1e-3));
        REQUIRE(left.wheel_speeds_radps[1] == Approx(-right.wheel_speeds_radps[2]).margin(1e-3));
      }
      step(world, a, kDt_s);
      step(other, b, kDt_s);
    }
  }
}

TEST_CASE("who is there already is told to stand") {
  Controller controller(Team::blue, {});
  WorldState world;
  world.sequence = 7;
  world.captured = from_us(1234);
  world.robots = {robot_at(5, {1, 1}, 2.0, {}, Team::blue)};
  const auto path = GENERATE(std::vector<Vec2>{{1, 1}}, std::vector<Vec2>{{0, 0}, {1, 1}});
  const TeamCommands commands = controller.update(world, std::vector{plan_along(5, path, 2.0, Team::blue)}, kDt_s);
  REQUIRE(commands.commands.size() == 1);
  CHECK(commands.commands[0] == RobotCommand{5, {}, {}, 0.0, 0.0});
  CHECK(commands.team == Team::blue);
  CHECK(commands.world_sequence == 7);
  CHECK(commands.captured == from_us(1234));
}

TEST_CASE("commands go to the team's robots in the world, in order, with a sequence that counts up") {
  Controller controller(Team::yellow, {});
  WorldState world;
  world.robots = {robot_at(1, {0, 0}), robot_at(4, {1, 0}), robot_at(4, {2, 0}, 0.0, {}, Team::blue)};
  // Plans for an opponent and for a robot nobody sees are not ours to drive.
  const std::vector<RobotPlan> plans{plan_along(4, {{2, 0}, {3, 0}}, 0.0, Team::blue), plan_along(9, {{0, 0}, {3, 0}})};
  const TeamCommands first = controller.update(world, plans, kDt_s);
  REQUIRE(first.commands.size() == 2);
  CHECK(first.commands[0].robot == 1);
  CHECK(first.commands[1].robot == 4);
  CHECK(first.commands[1].velocity == BodyVelocity{});
  world.robots.erase(world.robots.begin());
  const TeamCommands second = controller.update(world, plans, kDt_s);
  REQUIRE(second.commands.size() == 1);
  CHECK(second.sequence == first.sequence + 1);
  const TeamCommands third = controller.brake(nullptr, kDt_s);
  CHECK(third.commands.size() == 1);
  CHECK(third.sequence == second.sequence + 1);
  CHECK(Controller(Team::yellow, {}).brake(nullptr, kDt_s).commands.empty());
}

TEST_CASE("a robot seen first starts from its estimated motion, one that was hit from near it") {
  ControlParams params;
  params.drive_lag_s = 0.0;  // the lag's part of the position does use the estimated velocity
  Controller controller(Team::yellow, params);
  WorldState world;
  world.robots = {robot_at(0, {0, 0}, 0.0, {{2.0, 0.0}, 0.0})};
  const std::vector<RobotPlan> plans{plan_along(0, {{0, 0}, {5, 0}})};
  CHECK(controller.update(world, plans, kDt_s).commands[0].velocity.forward_mps == Approx(2.03));
  // Noise of the estimate does not reach the command.
  world.robots[0].twist.velocity_mps = {1.8, 0.3};
  const BodyVelocity next = controller.update(world, plans, kDt_s).commands[0].velocity;
  CHECK(next.forward_mps == Approx(2.06));
  CHECK(next.left_mps == Approx(0.0).margin(1e-12));
  // Held by somebody: the command comes back to what is plausible.
  world.robots[0].twist.velocity_mps = Vec2::Zero();
  CHECK(controller.update(world, plans, kDt_s).commands[0].velocity.forward_mps ==
        Approx(params.plausible_speed_error_mps + 0.03));
}

TEST_CASE("what is not finite, doubled or without duration is refused and leaves no trace") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  Controller controller(Team::yellow, {});
  WorldState world;
  world.robots = {robot_at(0, {0, 0})};
  const std::vector<RobotPlan> good{plan_along(0, {{0, 0}, {1, 0}})};
  std::vector<std::vector<RobotPlan>> bad(5, good);
  bad[0][0].plan.path[1].y() = nan;
  bad[1][0].plan.path[0].x() = infinite;
  bad[2][0].target.pose.heading_rad = nan;
  bad[3][0].target.speed_max_mps = nan;
  bad[4].push_back(good[0]);
  for (const auto& plans : bad) CHECK_THROWS_AS(controller.update(world, plans, kDt_s), std::invalid_argument);
  CHECK_THROWS_WITH(controller.update(world, bad[1], kDt_s), Catch::Contains("Y0") && Catch::Contains("inf"));
  CHECK_THROWS_AS(controller.update(world, good, 0.0), std::invalid_argument);
  CHECK_THROWS_AS(controller.update(world, good, nan), std::invalid_argument);
  CHECK_THROWS_AS(controller.brake(&world, -1.0), std::invalid_argument);
  WorldState broken = world;
  broken.robots[0].twist.velocity_mps.x() = nan;
  CHECK_THROWS_AS(controller.update(broken, good, kDt_s), std::invalid_argument);
  CHECK(controller.update(world, good, kDt_s) == Controller(Team::yellow, {}).update(world, good, kDt_s));
}

TEST_CASE("control's parameters are listed and set by name") {
  ControlParams params;
  set_param(params, "limits.speed_max_mps", "1.5");
  set_param(params, "wheels.hub_radius_m", "0.07");
  CHECK(params.limits.speed_max_mps == 1.5);
  CHECK(params.wheels.hub_radius_m == 0.07);
  CHECK_THROWS_AS(set_param(params, "follower.settle_time_s", "-1"), ParamError);
  // Every default lies within its own range.
  for (const ParamInfo& info : list_params(ControlParams{})) CHECK_NOTHROW(set_param(params, info.key, info.value));
  CHECK(params == ControlParams{});
}

}  // namespace
}  // namespace regista
