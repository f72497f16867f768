// The one-dimensional profiles against their definition: integrate, and compare with the formula.
#include "control/speed_profile.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "tests/control/ideal_team.h"

namespace regista {
namespace {

using test::Dice;

TEST_CASE("speed_before is the speed that braking reduces to the end speed over the distance") {
  CHECK(speed_before(0.0, 1.5, 4.0) == Approx(1.5));
  CHECK(speed_before(2.0, 0.0, 4.0) == Approx(4.0));
  const double speed = speed_before(0.7, 1.1, 3.3);
  const double time_s = (speed - 1.1) / 3.3;
  CHECK((speed + 1.1) / 2.0 * time_s == Approx(0.7));
}

TEST_CASE("trapezoid_duration of 3 m from rest to rest") {
  // Up in 1 s and 1.5 m, down in 0.75 s and 1.125 m, 0.375 m at 3 m/s between.
  CHECK(trapezoid_duration(3.0, 0.0, 0.0, 3.0, 3.0, 4.0) == Approx(1.0 + 0.75 + 0.125));
  // Too short to reach the limit: a triangle.
  CHECK(trapezoid_duration(0.875, 0.0, 0.0, 3.0, 4.0, 3.0) == Approx(std::sqrt(1.5 * 2.0) * (1.0 / 4.0 + 1.0 / 3.0)));
  CHECK(trapezoid_duration(0.0, 0.0, 0.0, 3.0, 3.0, 4.0) == 0.0);
}

TEST_CASE("trapezoid_duration agrees with driving it in small steps") {
  Dice dice(11);
  for (int i = 0; i < 200; ++i) {
    const double speed_max = dice.uniform(0.5, 4.0);
    const double acceleration = dice.uniform(1.0, 5.0);
    const double braking = dice.uniform(1.0, 5.0);
    const double distance = dice.uniform(0.2, 8.0);
    const double end = dice.uniform(0.0, 1.0) * std::min(speed_max, std::sqrt(2.0 * acceleration * distance));
    constexpr double kStep_s = 1e-4;
    double speed = 0.0;
    double left = distance;
    double time_s = 0.0;
    while (left > 0.0 && time_s < 60.0) {
      speed = std::min({speed + acceleration * kStep_s, speed_max, speed_before(left, end, braking)});
      left -= std::max(speed, 1e-3) * kStep_s;
      time_s += kStep_s;
    }
    INFO("distance " << distance << " end " << end << " limit " << speed_max << " up " << acceleration << " down "
                     << braking);
    CHECK(time_s == Approx(trapezoid_duration(distance, 0.0, end, speed_max, acceleration, braking)).epsilon(5e-3));
  }
}

TEST_CASE("trapezoid_duration refuses what cannot be driven") {
  CHECK_THROWS_AS(trapezoid_duration(0.1, 3.0, 0.0, 3.0, 3.0, 4.0), std::invalid_argument);
  CHECK_THROWS_AS(trapezoid_duration(-1.0, 0.0, 0.0, 3.0, 3.0, 4.0), std::invalid_argument);
  CHECK_THROWS_AS(trapezoid_duration(1.0, 0.0, 0.0, 3.0, 0.0, 4.0), std::invalid_argument);
  CHECK_THROWS_AS(trapezoid_duration(1.0, 4.0, 0.0, 3.0, 3.0, 4.0), std::invalid_argument);
}

TEST_CASE("approach_speed held step by step ends at the place, never beyond it, braking evenly") {
  Dice dice(12);
  for (int i = 0; i < 300; ++i) {
    const double braking = dice.uniform(1.0, 50.0);
    const double settle_s = dice.uniform(0.001, 0.3);
    const double dt_s = dice.uniform(0.001, 0.05);
    double distance = dice.uniform(0.0, 5.0);
    double last = approach_speed(distance, braking, settle_s, dt_s);
    INFO("braking " << braking << " settle " << settle_s << " dt " << dt_s << " distance " << distance);
    for (int step = 0; step < 100000 && distance > 1e-6; ++step) {
      const double speed = approach_speed(distance, braking, settle_s, dt_s);
      REQUIRE(last - speed <= 1.13 * braking * dt_s);  // the step from one part to the other brakes most
      distance -= speed * dt_s;
      REQUIRE(distance >= -1e-12);
      last = speed;
    }
    CHECK(distance <= 1e-6);
  }
  CHECK(approach_speed(0.0, 4.0, 0.08, 0.01) == 0.0);
}

}  // namespace
}  // namespace regista
