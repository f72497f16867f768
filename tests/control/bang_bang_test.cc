// Time-optimal motions to rest: they arrive when they say, along an axis as the trapezoid does, in the plane likewise.
#include "control/bang_bang.h"

#include <catch2/catch.hpp>

#include "control/motion_limits.h"
#include "control/speed_profile.h"
#include "tests/control/ideal_team.h"

namespace regista {
namespace {

using test::Dice;

const AxisLimits kLimits{3.0, 4.0, 3.0};

TEST_CASE("along an axis, moving towards the goal within limits, it is the trapezoid") {
  Dice dice(71);
  for (int i = 0; i < 1000; ++i) {
    const double velocity = dice.uniform(0.0, kLimits.speed_max);
    const double distance = velocity * velocity / (2.0 * kLimits.braking) + dice.uniform(0.0, 5.0);
    const double expected_s =
        trapezoid_duration(distance, velocity, 0.0, kLimits.speed_max, kLimits.acceleration, kLimits.braking);
    CHECK(bang_bang_duration(distance, velocity, kLimits) == Approx(expected_s));
    CHECK(bang_bang_duration(-distance, -velocity, kLimits) == Approx(expected_s));
  }
}

TEST_CASE("along an axis it is at rest at the goal after the duration, from any state, within limits") {
  constexpr int kSteps = 4000;
  Dice dice(72);
  for (int i = 0; i < 300; ++i) {
    const double distance = dice.uniform(-4.0, 4.0);
    const double velocity = dice.uniform(-4.0, 4.0);  // also above the speed limit
    const double duration_s = bang_bang_duration(distance, velocity, kLimits);
    double way = 0.0;
    double before = velocity;
    INFO("motion " << i << " of seed 72");
    for (int k = 1; k <= kSteps; ++k) {
      const double now = bang_bang_velocity(distance, velocity, kLimits, duration_s * k / kSteps);
      REQUIRE(std::abs(now - before) <= kLimits.braking * duration_s / kSteps + 1e-9);
      REQUIRE(std::abs(now) <= std::max(kLimits.speed_max, std::abs(velocity)) + 1e-9);
      way += (before + now) / 2.0 * duration_s / kSteps;
      before = now;
    }
    // Passing a goal that is too near and coming back is asked for anew by the next plan; the stop comes first.
    const double stopping = velocity * std::abs(velocity) / (2.0 * kLimits.braking);
    CHECK(before == Approx(0.0).margin(1e-6));
    CHECK(way == Approx(distance).margin(2e-3));
    CHECK(duration_s >= std::abs(distance - stopping) / std::max(kLimits.speed_max, std::abs(velocity)) - 1e-9);
  }
}

TEST_CASE(
    "in the plane, asked every period, it arrives at rest without overshoot, nearly as fast as a straight drive") {
  constexpr double kDt_s = 0.01;
  const RobotLimits limits;
  Dice dice(73);
  for (int i = 0; i < 200; ++i) {
    const bool from_rest = i % 2 == 0;
    Vec2 way = dice.direction() * dice.uniform(0.3, 4.0);
    Vec2 velocity = from_rest ? Vec2(Vec2::Zero()) : Vec2(dice.direction() * dice.uniform(0.0, 3.0));
    const double straight_s = trapezoid_duration(way.norm(), 0.0, 0.0, limits.speed_max_mps,
                                                 limits.acceleration_max_mps2, limits.braking_max_mps2);
    int tick = 0;
    for (; tick < 1000 && (way.norm() > 0.02 || velocity.norm() > 0.3); ++tick) {
      const Vec2 next = limited_velocity(velocity, bang_bang_velocity(way, velocity, limits, kDt_s), limits, kDt_s);
      way -= (velocity + next) / 2.0 * kDt_s;
      velocity = next;
    }
    INFO("motion " << i << " of seed 73");
    CHECK(tick < 1000);
    if (from_rest) CHECK(tick * kDt_s <= 1.1 * straight_s + 0.05);
  }
}

TEST_CASE("there already, at rest, nothing is asked for") {
  CHECK(bang_bang_velocity(Vec2::Zero(), Vec2::Zero(), RobotLimits{}, 0.01) == Vec2(0.0, 0.0));
}

}  // namespace
}  // namespace regista
