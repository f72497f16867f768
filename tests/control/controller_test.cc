// The controller's promises: limits, no jumps, braking without plan or world, memory, refusals. Robots obey at once.
#include "control/controller.h"

#include <rapidcheck.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/control/ideal_team.h"

namespace regista {
namespace {

using test::Dice;
using test::field_twist;
using test::plan_along;
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

WorldState random_world(Dice& dice, int robots, double speed_max) {
  WorldState world;
  for (int i = 0; i < robots; ++i) {
    const Twist twist{dice.direction() * dice.uniform(0.0, speed_max), dice.uniform(-speed_max, speed_max)};
    world.robots.push_back(
        robot_at(static_cast<std::uint16_t>(i), dice.point(6.0, 4.5), dice.uniform(-3.1, 3.1), twist));
  }
  return world;
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

TEST_CASE("without plan, with an invalid or an empty one: stopped within v²/2b, straight ahead") {
  const double heading_target = GENERATE(0.0, 3.0);  // driving straight, and turning meanwhile
  const int kind = GENERATE(0, 1, 2, 3);
  const ControlParams params;
  Controller controller(Team::yellow, params);
  WorldState world;
  world.robots = {robot_at(0, {0, 0}, 0.3)};
  const std::vector<RobotPlan> plans{plan_along(0, {{0, 0}, {6, 2}}, heading_target)};
  for (int tick = 0; tick < 30; ++tick) step(world, controller.update(world, plans, kDt_s), kDt_s);
  const RobotState start = world.robots[0];
  const double speed = start.twist.velocity_mps.norm();
  REQUIRE(speed > 0.8);

  RobotPlan invalid = plans[0];
  invalid.plan.status = PlanStatus::invalid;
  RobotPlan empty = plans[0];
  empty.plan.path.clear();
  const std::vector<RobotPlan> none = kind == 1   ? std::vector{invalid}
                                      : kind == 2 ? std::vector{empty}
                                                  : std::vector<RobotPlan>{};
  const WorldState stale = world;
  for (int tick = 0; tick < 100; ++tick) {
    step(world, kind == 3 ? controller.brake(&stale, kDt_s) : controller.update(world, none, kDt_s), kDt_s);
  }
  const RobotState& end = world.robots[0];
  CHECK(end.twist.velocity_mps.norm() == 0.0);
  CHECK(end.twist.angular_radps == 0.0);
  const Vec2 way = end.pose.position_m - start.pose.position_m;
  CHECK(way.norm() <= speed * speed / (2.0 * params.limits.braking_max_mps2));
  CHECK(std::abs(cross(start.twist.velocity_mps.normalized(), way)) <= 1e-9);
}

TEST_CASE("a robot that vision has lost brakes before it is taken from the world") {
  const ControlParams params;
  Controller controller(Team::yellow, params);
  WorldState world;
  world.robots.push_back(robot_at(0, {0.0, 0.0}, 0.0, Twist{{2.0, 0.0}, 0.0}));
  const std::vector<RobotPlan> plans{plan_along(0, {{0.0, 0.0}, {5.0, 0.0}}, 0.0)};
  world.robots[0].age = from_seconds(params.unseen_deadline_s);
  const double driving = controller.update(world, plans, kDt_s).commands[0].velocity.forward_mps;
  CHECK(driving >= 2.0);
  world.robots[0].age = from_seconds(params.unseen_deadline_s) + Duration{1};
  const double braking = controller.update(world, plans, kDt_s).commands[0].velocity.forward_mps;
  CHECK(braking == Approx(driving - params.limits.braking_max_mps2 * kDt_s));
}

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

TEST_CASE("among opponents that run into the team, robots drive slower towards them; without safety as ever") {
  const std::string mode = GENERATE("team", "none");
  ControlParams params;
  params.safety.mode = mode;
  params.rough_play.contacts = 3.0;
  Controller controller(Team::yellow, params);
  const std::vector<RobotPlan> plans{plan_along(0, {{-3, 0}, {3, 0}})};
  const RobotState drives = robot_at(0, {-1, 0}, 0.0, {{2.0, 0.0}, 0.0});
  const auto slowest_mps = [&] {
    WorldState world;
    world.robots = {drives, robot_at(3, {0, 0.3}, 0.0, {}, Team::blue)};
    double slowest = world.robots[0].twist.velocity_mps.x();
    for (int tick = 0; tick < 20; ++tick) {
      step(world, controller.update(world, plans, kDt_s), kDt_s);
      slowest = std::min(slowest, world.robots[0].twist.velocity_mps.x());
    }
    return slowest;
  };
  CHECK(slowest_mps() == Approx(2.0).margin(0.05));
  for (int contact = 0; contact < 4; ++contact) {
    for (const double apart_m : {0.17, 0.5}) {
      WorldState world;
      world.robots = {drives, robot_at(1, {3, 3}), robot_at(3, {3, 3 - apart_m}, 0.0, {}, Team::blue)};
      controller.update(world, plans, kDt_s);
    }
  }
  CHECK((slowest_mps() < 1.9) == (mode == "team"));
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
