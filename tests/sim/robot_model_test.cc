#include "sim/robot_model.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "sim/random.h"

namespace regista {
namespace {

constexpr double kDt_s = 0.001;

BodyVelocity random_command(Random& random) {
  const double forward = random.uniform(-6.0, 6.0);
  const double left = random.uniform(-6.0, 6.0);
  return {forward, left, random.uniform(-30.0, 30.0)};
}

TEST_CASE("a body never exceeds its limits, whatever it is told") {
  const RobotLimits limits;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    const double lag_s = seed % 2 == 0 ? 0.03 : 0.0;
    RobotBody body;
    BodyVelocity command;
    for (int i = 0; i < 3000; ++i) {
      if (i % 50 == 0) command = random_command(random);
      const Twist before = body.twist;
      if (random.chance(0.1)) {
        brake(body, limits, kDt_s);
      } else {
        step(body, command, limits, lag_s, kDt_s);
      }
      REQUIRE(body.twist.velocity_mps.norm() <= limits.speed_max_mps + 1e-12);
      REQUIRE(std::abs(body.twist.angular_radps) <= limits.angular_speed_max_radps + 1e-12);
      REQUIRE(std::abs(body.twist.angular_radps - before.angular_radps) <=
              limits.angular_acceleration_max_radps2 * kDt_s + 1e-12);
      REQUIRE(std::abs(body.pose.heading_rad) <= std::numbers::pi);
      const double gained = body.twist.velocity_mps.norm() - before.velocity_mps.norm();
      REQUIRE(gained <= limits.acceleration_max_mps2 * kDt_s + 1e-12);
      REQUIRE(-gained <= limits.braking_max_mps2 * kDt_s + 1e-12);
      const Vec2 change = body.twist.velocity_mps - before.velocity_mps;
      REQUIRE(change.norm() <= limits.braking_max_mps2 * kDt_s + 1e-12);
    }
  }
}

TEST_CASE("acceleration and braking are used in full, and a stop is exact") {
  const RobotLimits limits;
  RobotBody body;
  for (int i = 0; i < 1000; ++i) step(body, {3.0, 0.0, 0.0}, limits, 0.0, kDt_s);
  CHECK(body.twist.velocity_mps.x() == Approx(3.0));
  CHECK(body.pose.position_m.x() == Approx(1.5));  // v²/2a
  for (int i = 0; i < 749; ++i) brake(body, limits, kDt_s);
  CHECK(body.twist.velocity_mps.x() == Approx(0.004).margin(1e-9));
  brake(body, limits, kDt_s);
  brake(body, limits, kDt_s);
  CHECK(body.twist.velocity_mps == Vec2(0.0, 0.0));
  CHECK(body.pose.position_m.x() == Approx(1.5 + 9.0 / 8.0));  // v²/2b
}

TEST_CASE("the lag is first order") {
  RobotLimits limits;
  limits.acceleration_max_mps2 = 50.0;  // out of the way
  RobotBody body;
  for (int i = 0; i < 30; ++i) step(body, {1.0, 0.0, 0.0}, limits, 0.03, kDt_s);
  CHECK(body.twist.velocity_mps.x() == Approx(1.0 - std::exp(-1.0)));
}

TEST_CASE("commands are in the body's frame") {
  const RobotLimits limits;
  RobotBody body;
  body.pose.heading_rad = std::numbers::pi / 2.0;
  for (int i = 0; i < 500; ++i) step(body, {1.0, 0.5, 0.0}, limits, 0.0, kDt_s);
  CHECK(body.twist.velocity_mps.x() == Approx(-0.5));
  CHECK(body.twist.velocity_mps.y() == Approx(1.0));
}

TEST_CASE("driving and turning at once runs a circle") {
  const RobotLimits limits;
  RobotBody body;
  body.twist = {{1.0, 0.0}, 1.0};  // radius 1 m about (0, 1)
  for (int i = 0; i < 3000; ++i) {
    step(body, {1.0, 0.0, 1.0}, limits, 0.0, kDt_s);
    REQUIRE((body.pose.position_m - Vec2(0.0, 1.0)).norm() == Approx(1.0).margin(1e-5));
  }
  CHECK(body.pose.heading_rad == Approx(3.0));
}

}  // namespace
}  // namespace regista
