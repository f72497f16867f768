// How the simulator's robots drive as told, touch each other, and kick the ball.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "sim/simulator.h"
#include "tests/sim/one_robot.h"

namespace regista {
namespace {

using test::kBlue;
using test::kYellow;
using test::one_robot;
using test::tell;

TEST_CASE("without command a robot stops within the timeout and v/b, in v²/2b") {
  const SimParams params = sim_preset("noisy");
  Simulator simulator(one_robot(params));
  for (int i = 0; i < 150; ++i) {
    simulator.command(tell(kYellow, {3.0, 0.0, 0.5}), simulator.now());
    simulator.advance_to(simulator.now() + Duration{10'000});
  }
  const Time last_arrival = simulator.now() - Duration{10'000};
  const Time silent = last_arrival + from_seconds(params.radio.latency_s + params.radio.timeout_s);
  simulator.advance_to(silent);
  const RobotState moving = simulator.truth().robots[0];
  const double speed = moving.twist.velocity_mps.norm();
  CHECK(speed > 1.0);
  simulator.advance_to(silent + from_seconds(speed / params.limits.braking_max_mps2) + kSimStep);
  const RobotState stopped = simulator.truth().robots[0];
  CHECK(stopped.twist == Twist{});
  CHECK((stopped.pose.position_m - moving.pose.position_m).norm() ==
        Approx(speed * speed / (2.0 * params.limits.braking_max_mps2)).margin(0.005));
}

TEST_CASE("a command moves the robot exactly a latency after it arrived") {
  SimParams params;
  params.radio.latency_s = 0.030;
  Simulator simulator(one_robot(params));
  simulator.advance_to(from_us(5000));
  simulator.command(tell(kYellow, {1.0, 0.0, 0.0}), from_us(5000));
  simulator.advance_to(from_us(35'000));
  CHECK(simulator.truth().robots[0].twist == Twist{});
  simulator.advance_to(from_us(36'000));
  CHECK(simulator.truth().robots[0].twist.velocity_mps.x() == Approx(0.003));
}

TEST_CASE("a robot drives the gain's part of its command") {
  SimParams params;
  params.velocity_gain = 1.05;
  Simulator simulator(one_robot(params));
  for (int i = 0; i < 100; ++i) {
    simulator.command(tell(kYellow, {0.0, 2.0, 0.0}), simulator.now());
    simulator.advance_to(simulator.now() + Duration{10'000});
  }
  CHECK(simulator.truth().robots[0].twist.velocity_mps.norm() == Approx(2.1));
  for (int i = 0; i < 100; ++i) {
    simulator.command(tell(kYellow, {0.0, 0.0, 1.0}), simulator.now());
    simulator.advance_to(simulator.now() + Duration{10'000});
  }
  CHECK(simulator.truth().robots[0].twist.angular_radps == Approx(1.05));
  for (int i = 0; i < 100; ++i) {
    simulator.command(tell(kYellow, {3.0, 0.0, 1.0}), simulator.now());
    simulator.advance_to(simulator.now() + Duration{10'000});
  }
  CHECK(simulator.truth().robots[0].twist.velocity_mps.norm() <= params.limits.speed_max_mps + 1e-9);
}

TEST_CASE("fast robots that would jump through each other in one step touch") {
  SimSetup setup;
  setup.params.limits.speed_max_mps = 20.0;  // 20 mm a step: a chord of 30 mm of both discs is passed in two
  setup.params.limits.acceleration_max_mps2 = 100.0;
  setup.robots = {{kYellow, {{-2.0, 0.0}, 0.0}}, {kBlue, {{2.0, 0.1799}, std::numbers::pi}}};
  setup.ball_m = {0.0, 3.0};
  Simulator simulator(setup);
  for (int i = 0; i < 60; ++i) {
    simulator.command(tell(kYellow, {20.0, 0.0, 0.0}), simulator.now());
    simulator.command(tell(kBlue, {20.0, 0.0, 0.0}), simulator.now());
    simulator.advance_to(simulator.now() + Duration{5'000});
  }
  CHECK(simulator.contact_counts().opponent == 1);
}

TEST_CASE("robots that drive into each other touch, are judged and do not pass through") {
  SimSetup setup;
  setup.robots = {{kBlue, {{1.0, 0.0}, std::numbers::pi}}, {kYellow, {{-1.0, 0.0}, 0.0}}};
  setup.ball_m = {0.0, 3.0};
  Simulator simulator(setup);
  for (int i = 0; i < 200; ++i) {
    simulator.command(tell(kYellow, {3.0, 0.0, 0.0}), simulator.now());
    simulator.command(tell(kBlue, {1.0, 0.0, 0.0}), simulator.now());
    simulator.advance_to(simulator.now() + Duration{10'000});
  }
  CHECK(simulator.contact_counts() == ContactCounts{0, 0, 1, 1, 0});
  REQUIRE(simulator.contacts().size() == 1);
  CHECK(simulator.contacts()[0].fault == Fault::first);
  const WorldState truth = simulator.truth();
  const Vec2 off = find_robot(truth, kBlue)->pose.position_m - find_robot(truth, kYellow)->pose.position_m;
  CHECK(off.x() == Approx(0.18).margin(0.003));
}

TEST_CASE("a kick sends the ball along the heading, as far as it runs") {
  SimParams params;
  Simulator simulator(one_robot(params));
  simulator.teleport(kYellow, {{-4.0, -1.0}, 0.3});
  const Vec2 ahead = rotated({1.0, 0.0}, 0.3);
  const Vec2 ball = Vec2(-4.0, -1.0) + 0.12 * ahead;
  simulator.teleport_ball(ball, {0.0, 0.0});
  simulator.command(tell(kYellow, {}, 2.0), simulator.now());
  simulator.advance_to(simulator.now() + Duration{10'000'000});
  const BallState rested = *simulator.truth().ball;
  CHECK(rested.velocity_mps == Vec2(0.0, 0.0));
  // Slides from v to 0.69 v at 3.9 m/s², then rolls at 0.35 m/s².
  const double run_m = 2.0 * 2.0 * ((1.0 - 0.69 * 0.69) / 7.8 + 0.69 * 0.69 / 0.7);
  CHECK((rested.position_m - ball).norm() == Approx(run_m));
  CHECK(cross(ahead, rested.position_m - ball) == Approx(0.0).margin(1e-9));
}

TEST_CASE("no kick without its command") {
  Simulator simulator(one_robot({}));
  simulator.teleport_ball({-3.0 + 0.12, 1.0}, {0.0, 0.0});
  simulator.command(tell(kYellow, {}), simulator.now());
  simulator.advance_to(simulator.now() + Duration{100'000});
  CHECK(simulator.truth().ball->position_m == Vec2(-3.0 + 0.12, 1.0));
}

TEST_CASE("the boards keep the ball in") {
  Simulator simulator(one_robot({}));
  simulator.teleport_ball({0.0, 0.0}, {3.0, 6.0});
  for (int i = 0; i < 300; ++i) {
    simulator.advance_to(simulator.now() + Duration{10'000});
    const Vec2 position = simulator.truth().ball->position_m;
    REQUIRE(std::abs(position.x()) <= 6.6 - 0.0215);
    REQUIRE(std::abs(position.y()) <= 4.8 - 0.0215);
  }
  CHECK(simulator.truth().ball->velocity_mps.y() < 0.0);
}

}  // namespace
}  // namespace regista
