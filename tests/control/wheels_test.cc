#include "control/wheels.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "tests/control/ideal_team.h"

namespace regista {
namespace {

using test::Dice;

TEST_CASE("driving forward, the left wheels roll backwards around the robot and the right ones forwards") {
  const OmniWheels wheels{WheelGeometry{}};
  const WheelSpeeds speeds = wheels.speeds({1.0, 0.0, 0.0});
  CHECK(speeds[0] == Approx(-std::sin(57.0 * std::numbers::pi / 180.0) / 0.0305));
  CHECK(speeds[1] == Approx(-std::sqrt(0.5) / 0.0305));
  CHECK(speeds[2] == Approx(-speeds[1]));
  CHECK(speeds[3] == Approx(-speeds[0]));
}

TEST_CASE("driving left, front wheels and rear wheels roll against each other") {
  const WheelSpeeds speeds = OmniWheels{WheelGeometry{}}.speeds({0.0, 1.0, 0.0});
  CHECK(speeds[0] == Approx(std::cos(57.0 * std::numbers::pi / 180.0) / 0.0305));
  CHECK(speeds[3] == Approx(speeds[0]));
  CHECK(speeds[1] == Approx(-std::sqrt(0.5) / 0.0305));
  CHECK(speeds[2] == Approx(speeds[1]));
}

TEST_CASE("turning on the spot, all wheels roll alike") {
  const WheelSpeeds speeds = OmniWheels{WheelGeometry{}}.speeds({0.0, 0.0, 2.0});
  for (const double speed : speeds) CHECK(speed == Approx(2.0 * 0.08 / 0.0305));
}

TEST_CASE("odometry: velocity(speeds(v)) = v for any geometry") {
  Dice dice(21);
  for (int i = 0; i < 1000; ++i) {
    WheelGeometry geometry;
    geometry.front_bearing_rad = dice.uniform(0.2, 1.5);
    geometry.rear_bearing_rad = dice.uniform(1.6, 3.0);
    geometry.hub_radius_m = dice.uniform(0.02, 0.5);
    geometry.wheel_radius_m = dice.uniform(0.01, 0.1);
    const OmniWheels wheels{geometry};
    const BodyVelocity v{dice.uniform(-5, 5), dice.uniform(-5, 5), dice.uniform(-20, 20)};
    const BodyVelocity back = wheels.velocity(wheels.speeds(v));
    CHECK(back.forward_mps == Approx(v.forward_mps).margin(1e-9));
    CHECK(back.left_mps == Approx(v.left_mps).margin(1e-9));
    CHECK(back.angular_radps == Approx(v.angular_radps).margin(1e-9));
  }
}

TEST_CASE("odometry averages a slipping wheel: no other velocity explains the wheels better") {
  Dice dice(22);
  const OmniWheels wheels{WheelGeometry{}};
  const auto misfit = [&](const BodyVelocity& v, const WheelSpeeds& measured) {
    double sum = 0.0;
    const WheelSpeeds speeds = wheels.speeds(v);
    for (std::size_t i = 0; i < 4; ++i) sum += (speeds[i] - measured[i]) * (speeds[i] - measured[i]);
    return sum;
  };
  for (int i = 0; i < 200; ++i) {
    WheelSpeeds measured;
    for (double& speed : measured) speed = dice.uniform(-100, 100);
    const BodyVelocity best = wheels.velocity(measured);
    const BodyVelocity other{best.forward_mps + dice.uniform(-0.1, 0.1), best.left_mps + dice.uniform(-0.1, 0.1),
                             best.angular_radps + dice.uniform(-1, 1)};
    CHECK(misfit(best, measured) <= misfit(other, measured));
  }
}

TEST_CASE("four bearings of their own, where they are given") {
  WheelGeometry given;
  given.bearings_rad = "0.9948376736367679,2.356194490192345,-2.356194490192345,-0.9948376736367679";
  const BodyVelocity v{0.7, -1.2, 3.0};
  const WheelSpeeds mirrored = OmniWheels{WheelGeometry{}}.speeds(v);
  const WheelSpeeds same = OmniWheels{given}.speeds(v);
  for (std::size_t i = 0; i < 4; ++i) CHECK(same[i] == Approx(mirrored[i]));
  Dice dice(23);
  for (int i = 0; i < 500; ++i) {
    WheelGeometry any;
    const std::array<double, 4> bearings{dice.uniform(0.3, 1.3), dice.uniform(1.8, 2.8), dice.uniform(-2.8, -1.8),
                                         dice.uniform(-1.3, -0.3)};
    for (const double bearing : bearings) {
      any.bearings_rad += (any.bearings_rad.empty() ? "" : ",") + std::to_string(bearing);
    }
    const OmniWheels wheels{any};
    const WheelSpeeds speeds = wheels.speeds({1.0, 0.0, 0.0});
    for (std::size_t w = 0; w < 4; ++w) CHECK(speeds[w] == Approx(-std::sin(bearings[w]) / 0.0305).margin(1e-4));
    const BodyVelocity back = wheels.velocity(wheels.speeds(v));
    CHECK(back.left_mps == Approx(v.left_mps));
    CHECK(back.angular_radps == Approx(v.angular_radps));
  }
  for (const char* bad :
       {"1", "1,2,-2", "1,2,-2,-1,0", "1,2,-2,x", "1,2,-2,nan", "1,2,-2,", "1;2;-2;-1", "9,2,-2,-1"}) {
    CAPTURE(bad);
    given.bearings_rad = bad;
    CHECK_THROWS_WITH(OmniWheels{given}, Catch::Contains(bad));
  }
}

TEST_CASE("the limit scales all wheels together") {
  const OmniWheels wheels{WheelGeometry{}};
  CHECK(wheels.scale_to_limit({100.0, -160.0, 0.0, 3.0}) == 1.0);
  CHECK(wheels.scale_to_limit({100.0, -320.0, 0.0, 3.0}) == Approx(0.5));
  CHECK(wheels.scale_to_limit({0.0, 0.0, 0.0, 0.0}) == 1.0);
}

TEST_CASE("wheels that cannot move a robot are refused") {
  WheelGeometry parallel;
  parallel.front_bearing_rad = 0.0;
  parallel.rear_bearing_rad = std::numbers::pi;
  CHECK_THROWS_AS(OmniWheels{parallel}, std::invalid_argument);
  WheelGeometry no_wheel;
  no_wheel.wheel_radius_m = 0.0;
  CHECK_THROWS_AS(OmniWheels{no_wheel}, std::invalid_argument);
}

}  // namespace
}  // namespace regista
