// The controller slows robots down: without a plan or a world, out of vision's sight, and among opponents that run into
// the team.
#include <catch2/catch.hpp>
#include <cmath>

#include "control/controller.h"
#include "tests/control/ideal_team.h"

namespace regista {
namespace {

using test::plan_along;
using test::robot_at;
using test::step;

constexpr double kDt_s = 0.01;

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

}  // namespace
}  // namespace regista
