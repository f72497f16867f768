#include "sim/ball_model.h"

#include <catch2/catch.hpp>
#include <numbers>

#include "sim/walls.h"

namespace regista {
namespace {

double run(double speed_mps, const BallParams& params, double dt_s) {
  BallBody ball;
  kick(ball, {0.0, speed_mps}, params);
  for (int i = 0; i < 1'000'000 && ball.velocity_mps.norm() > 0.0; ++i) step(ball, params, dt_s);
  CHECK(ball.position_m.x() == 0.0);
  return ball.position_m.y();
}

TEST_CASE("the ball runs as far as the formula says, whatever the step") {
  const BallParams params;
  for (const double speed : {0.1, 1.0, 3.0, 6.5}) {
    // Slides from v to 0.69 v at 3.9 m/s², then rolls at 0.35 m/s².
    const double expected = speed * speed * ((1.0 - 0.69 * 0.69) / 7.8 + 0.69 * 0.69 / 0.7);
    CHECK(run(speed, params, 0.001) == Approx(expected));
    CHECK(run(speed, params, 0.037) == Approx(expected));
  }
}

TEST_CASE("no kick exceeds the legal speed") {
  const BallParams params;
  BallBody ball;
  kick(ball, {9.0, 0.0}, params);
  CHECK(ball.velocity_mps.x() == Approx(6.5));
}

TEST_CASE("a robot pushes the ball ahead with its own speed") {
  const BallParams params;
  RobotBody robot;
  robot.twist.velocity_mps = {1.0, 0.0};
  BallBody ball;
  ball.position_m = {0.1, 0.0};
  push(ball, robot, 0.09, params);
  CHECK(ball.position_m.x() == Approx(0.09 + params.radius_m));
  CHECK(ball.velocity_mps == Vec2(1.0, 0.0));
  step(ball, params, 0.001);
  CHECK(ball.velocity_mps.x() == Approx(1.0 - 0.35e-3));  // it rolls

  const BallBody faster{{0.1, 0.0}, {2.0, 0.0}, 2.0};
  ball = faster;
  push(ball, robot, 0.09, params);
  CHECK(ball.velocity_mps == faster.velocity_mps);

  const BallBody away{{0.112, 0.0}, {-1.0, 0.0}, 2.0};
  ball = away;
  push(ball, robot, 0.09, params);
  CHECK(ball == away);
}

TEST_CASE("the kicker reaches what is near and ahead") {
  const BallParams params;
  RobotBody robot;
  robot.pose = {{1.0, 2.0}, std::numbers::pi / 2.0};
  const auto reaches = [&](double distance_m, double angle_rad) {
    BallBody ball;
    ball.position_m = robot.pose.position_m + distance_m * rotated({1.0, 0.0}, robot.pose.heading_rad + angle_rad);
    return can_kick(ball, robot, 0.09, params);
  };
  CHECK(reaches(0.112, 0.0));
  CHECK(reaches(0.12, 0.34));
  CHECK(reaches(0.12, -0.34));
  CHECK_FALSE(reaches(0.12, 0.36));
  CHECK_FALSE(reaches(0.12, std::numbers::pi));
  CHECK_FALSE(reaches(0.14, 0.0));
}

TEST_CASE("walls stop a disc and give back part of its normal speed") {
  const Walls walls = walls_of(division_a());
  Vec2 position(6.59, 1.5);
  Vec2 velocity(2.0, 1.0);
  keep_off(walls, 0.0215, 0.5, position, velocity);
  CHECK(position.x() == Approx(6.6 - 0.0215));
  CHECK(velocity.x() == Approx(-1.0));
  CHECK(velocity.y() == 1.0);

  // The goal's back wall, from inside the goal on the -x side, and its side wall from outside.
  position = {-6.17, 0.2};
  velocity = {-1.0, 0.0};
  keep_off(walls, 0.0215, 0.0, position, velocity);
  CHECK(position.x() == Approx(-6.18 + 0.0215));
  CHECK(velocity.x() == 0.0);
  position = {6.1, -0.95};
  velocity = {0.0, 1.0};
  keep_off(walls, 0.09, 0.0, position, velocity);
  CHECK(position.y() == Approx(-0.92 - 0.09));
  CHECK(velocity.y() == 0.0);

  // Free: in the goal mouth, on the field.
  for (const Vec2& free : {Vec2(5.95, 0.0), Vec2(1.0, -4.6), Vec2(6.0, 0.8)}) {
    position = free;
    velocity = {1.0, 1.0};
    keep_off(walls, 0.0215, 0.5, position, velocity);
    CHECK(position == free);
    CHECK(velocity == Vec2(1.0, 1.0));
  }
}

}  // namespace
}  // namespace regista
