// Controller and robot in a loop: robots that obey at once, and robots as they are, with delay, lag and noisy vision.
#include <catch2/catch.hpp>
#include <cmath>
#include <deque>

#include "control/controller.h"
#include "tests/control/ideal_team.h"

namespace regista {
namespace {

using test::Dice;
using test::field_twist;
using test::from_here;
using test::plan_along;
using test::robot_at;
using test::step;

constexpr double kDt_s = 0.01;

ControlParams without_lag() {
  ControlParams params;
  params.drive_lag_s = 0.0;
  return params;
}

TEST_CASE("from any state to any pose: within 5 mm and 0.02 rad, at rest, without overshoot") {
  Dice dice(51);
  for (int run = 0; run < 300; ++run) {
    Controller controller(Team::yellow, without_lag());
    WorldState world;
    world.robots = {robot_at(0, dice.point(5, 4), dice.uniform(-3.1, 3.1),
                             {dice.direction() * dice.uniform(0, 3), dice.uniform(-10, 10)})};
    const Vec2 goal = dice.point(5, 4);
    const double heading = dice.uniform(-3.1, 3.1);
    double beyond_m = 0.0;
    bool arrived = false;
    for (int tick = 0; tick < 1000; ++tick) {
      // Planned anew every tick from where the robot is, as the planner does.
      const std::vector<RobotPlan> plans{plan_along(0, {world.robots[0].pose.position_m, goal}, heading)};
      step(world, controller.update(world, plans, kDt_s), kDt_s);
      const double distance_m = (world.robots[0].pose.position_m - goal).norm();
      arrived = arrived || (distance_m <= 0.005 && world.robots[0].twist.velocity_mps.norm() <= 0.1);
      if (arrived) beyond_m = std::max(beyond_m, distance_m);
    }
    const RobotState& end = world.robots[0];
    INFO("run " << run << " of seed 51");
    CHECK(arrived);
    CHECK(beyond_m <= 0.010);
    CHECK((end.pose.position_m - goal).norm() <= 0.005);
    CHECK(std::abs(wrap_angle(end.pose.heading_rad - heading)) <= 0.02);
    CHECK(end.twist.velocity_mps.norm() <= 1e-3);
    CHECK(std::abs(end.twist.angular_radps) <= 1e-3);
  }
}

TEST_CASE("the heading is reached on the way, the near way round") {
  Controller controller(Team::yellow, without_lag());
  WorldState world;
  world.robots = {robot_at(0, {0, 0}, 3.0)};
  const std::vector<RobotPlan> plans{plan_along(0, {{0, 0}, {3, 0}}, -3.0)};
  for (int tick = 0; tick < 60; ++tick) {
    step(world, controller.update(world, plans, kDt_s), kDt_s);
    REQUIRE(world.robots[0].twist.angular_radps >= 0.0);
  }
  CHECK(std::abs(wrap_angle(world.robots[0].pose.heading_rad + 3.0)) <= 0.02);
  CHECK(world.robots[0].pose.position_m.x() < 1.0);
  CHECK(std::abs(world.robots[0].pose.position_m.y()) <= 1e-9);  // turning does not bend the way
}

/// A robot whose drive follows commands with a lag, after a delay; the controller sees it predicted over the delay,
/// with the noise of vision.
struct RealRobot {
  static constexpr int kDelay = 3;  ///< ticks: 30 ms
  double lag_s = 0.03;
  double position_noise_m = 0.0;
  RobotState state;
  std::deque<Twist> queue = std::deque<Twist>(kDelay, Twist{});

  static void advance(RobotState& robot, const Twist& command, double lag_s) {
    const double share = 1.0 - std::exp(-kDt_s / lag_s);
    robot.twist.velocity_mps += (command.velocity_mps - robot.twist.velocity_mps) * share;
    robot.twist.angular_radps += (command.angular_radps - robot.twist.angular_radps) * share;
    robot.pose.position_m += robot.twist.velocity_mps * kDt_s;
    robot.pose.heading_rad = wrap_angle(robot.pose.heading_rad + robot.twist.angular_radps * kDt_s);
  }

  RobotState seen(Dice& dice) const {
    RobotState robot = state;
    for (const Twist& command : queue) advance(robot, command, lag_s);
    const double scale = position_noise_m / 0.0013;  // heading and velocity as fits 1.3 mm
    robot.pose.position_m += position_noise_m * Vec2(dice.normal(), dice.normal());
    robot.pose.heading_rad = wrap_angle(robot.pose.heading_rad + 0.01 * scale * dice.normal());
    robot.twist.velocity_mps += 0.05 * scale * Vec2(dice.normal(), dice.normal());
    robot.twist.angular_radps += 0.3 * scale * dice.normal();
    return robot;
  }

  /// `replanned`: the plan is from where the robot is seen; else it is taken as it stands. Returns its path.
  std::vector<Vec2> tick(Controller& controller, RobotPlan plan, Dice& dice, bool replanned = false) {
    WorldState world;
    world.robots = {seen(dice)};
    if (replanned) plan.plan.path = from_here(plan.plan.path, world.robots[0].pose.position_m);
    const TeamCommands commands = controller.update(world, std::vector{plan}, kDt_s);
    queue.push_back(field_twist(commands.commands[0], world.robots[0].pose.heading_rad, kDt_s));
    advance(state, queue.front(), lag_s);
    queue.pop_front();
    return plan.plan.path;
  }
};

/// Of commanded accelerations from one period to the next, m/s².
struct Jumps {
  double largest = 0.0;
  double sum = 0.0;
  int count = 0;

  void add(const Vec2& velocity_mps, bool counts) {
    const Vec2 acceleration = (velocity_mps - velocity_) / kDt_s;
    const double jump = (acceleration - acceleration_).norm();
    if (counts) {
      largest = std::max(largest, jump);
      sum += jump;
      ++count;
    }
    velocity_ = velocity_mps;
    acceleration_ = acceleration;
  }

 private:
  Vec2 velocity_ = Vec2::Zero();
  Vec2 acceleration_ = Vec2::Zero();
};

TEST_CASE("with delay, lag and noise: arrives without overshoot and stays without limit cycle") {
  Dice dice(52);
  for (int run = 0; run < 100; ++run) {
    Controller controller(Team::yellow, {});
    RealRobot robot;
    robot.position_noise_m = 0.0013;
    robot.state = robot_at(0, {0, 0}, dice.uniform(-3.1, 3.1));
    const Vec2 goal = dice.direction() * dice.uniform(0.3, 4.0);
    const RobotPlan plan = plan_along(0, {{0, 0}, goal}, dice.uniform(-3.1, 3.1));
    bool arrived = false;
    double beyond_m = 0.0;
    double squared_speed = 0.0;
    for (int tick = 0; tick < 600; ++tick) {
      robot.tick(controller, plan, dice);
      const double distance_m = (robot.state.pose.position_m - goal).norm();
      arrived = arrived || (distance_m <= 0.005 && robot.state.twist.velocity_mps.norm() <= 0.1);
      if (arrived) beyond_m = std::max(beyond_m, distance_m);
      if (tick >= 500) squared_speed += robot.state.twist.velocity_mps.squaredNorm() / 100.0;
    }
    INFO("run " << run << " of seed 52");
    CHECK(arrived);
    CHECK(beyond_m <= 0.010);
    CHECK(std::sqrt(squared_speed) <= 0.015);
    CHECK(std::abs(wrap_angle(robot.state.pose.heading_rad - plan.target.pose.heading_rad)) <= 0.03);
  }
}

TEST_CASE("with delay, lag, noise and a new path every frame there is neither jitter nor overshoot") {
  constexpr int kKnown = 2;  // periods until the last command, not a noisy estimate, is what the robot is taken to do
  Dice dice(53);
  ControlParams params;
  params.wheels.wheel_speed_max_radps = 1e3;
  for (int run = 0; run < 60; ++run) {
    Controller controller(Team::yellow, params);
    RealRobot robot;
    robot.position_noise_m = 0.0013;
    robot.state = robot_at(0, {0, 0}, dice.uniform(-3.1, 3.1));
    std::vector<Vec2> path{{0, 0}, dice.point(2, 2), dice.point(2, 2), dice.point(2, 2)};
    const Vec2 goal = path.back();
    const double heading = dice.uniform(-3.1, 3.1);
    Jumps driving;
    double beyond_m = 0.0;
    bool arrived = false;
    for (int tick = 0; tick < 1200; ++tick) {
      path = robot.tick(controller, plan_along(0, path, heading), dice, true);
      const double distance_m = (robot.state.pose.position_m - goal).norm();
      driving.add(robot.queue.back().velocity_mps, tick > kKnown && distance_m > 0.3);
      arrived = arrived || (distance_m <= 0.005 && robot.state.twist.velocity_mps.norm() <= 0.1);
      if (arrived) beyond_m = std::max(beyond_m, distance_m);
    }
    INFO("run " << run << " of seed 53");
    CHECK(arrived);
    CHECK(beyond_m <= 0.010);
    CHECK((robot.state.pose.position_m - goal).norm() <= 0.005);
    CHECK(std::abs(wrap_angle(robot.state.pose.heading_rad - heading)) <= 0.03);
    // From full braking one way to full braking the other way is the most that limits allow; noise must not use it.
    CHECK(driving.largest <= 2.0 * params.limits.braking_max_mps2 + 1e-6);
    CHECK(driving.sum <= 2.5 * driving.count);
  }
}

TEST_CASE("planned anew every frame a straight way gets the commands of the plan that was kept") {
  Dice dice(54);
  for (int run = 0; run < 50; ++run) {
    Controller kept(Team::yellow, without_lag());
    Controller renewed(Team::yellow, without_lag());
    const std::vector<Vec2> path{dice.point(4, 4), dice.point(4, 4)};
    WorldState world;
    world.robots = {robot_at(0, path[0])};
    for (int tick = 0; tick < 300; ++tick) {
      const RobotPlan again = plan_along(0, from_here(path, world.robots[0].pose.position_m));
      const TeamCommands expected = kept.update(world, std::vector{plan_along(0, path)}, kDt_s);
      const TeamCommands commands = renewed.update(world, std::vector{again}, kDt_s);
      INFO("run " << run << " of seed 54, tick " << tick);
      CHECK((field_twist(commands.commands[0], 0.0, kDt_s).velocity_mps -
             field_twist(expected.commands[0], 0.0, kDt_s).velocity_mps)
                .norm() <= 1e-6);
      step(world, expected, kDt_s);
    }
  }
}

}  // namespace
}  // namespace regista
