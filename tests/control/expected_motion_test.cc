// What opponents are expected to do while they speed up: until their team's top speed, where that is known.
#include "control/safety/expected_motion.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/control/ideal_team.h"

namespace regista {
namespace {

using test::Dice;

double speed_at(const Motion& motion, double time_s) {
  const Phase& phase = motion.phase_at(time_s);
  return velocity_after(phase, time_s - phase.begin_s).norm();
}

TEST_CASE("who speeds up straight ahead does so to its team's top speed and no further, if that is known") {
  Dice dice(71);
  SafetyParams params;
  params.speeding_up_lasts_s = 0.8;
  int reached = 0;
  for (int i = 0; i < 500; ++i) {
    Opponent opponent{.position_m = dice.point(3.0, 3.0), .velocity_mps = dice.point(2.0, 2.0)};
    const double speed = opponent.velocity_mps.norm();
    if (speed < 0.1 || speed > 2.05) continue;
    const double acceleration = 0.5 + dice.point(2.0, 2.0).norm();
    opponent.acceleration_mps2 = acceleration / speed * opponent.velocity_mps;
    opponent.speed_max_mps = 2.0;
    const Motion motion = expected_motion(opponent, {}, params);
    INFO("opponent " << i << " of seed 71");
    for (double t = 0.0; t < params.horizon_s; t += 0.05) {
      const double gained_mps = acceleration * std::min(t, params.speeding_up_lasts_s);
      CHECK(speed_at(motion, t) == Approx(std::max(speed, std::min(2.0, speed + gained_mps))).margin(1e-9));
    }
    reached += speed < 2.0 && speed + 0.8 * acceleration > 2.0 ? 1 : 0;
  }
  CHECK(reached > 100);
}

TEST_CASE("where the top speed is not known, or in a turn, an acceleration lasts as long as any") {
  const SafetyParams params;
  Opponent opponent{.velocity_mps = {1.5, 0.0}, .acceleration_mps2 = {3.0, 0.0}};
  CHECK(speed_at(expected_motion(opponent, {}, params), 0.9) == Approx(1.5 + 3.0 * params.acceleration_lasts_s));
  opponent.speed_max_mps = 1.3;  // it proves that wrong
  CHECK(speed_at(expected_motion(opponent, {}, params), 0.9) == Approx(1.5 + 3.0 * params.acceleration_lasts_s));
  opponent.speed_max_mps = 1.6;
  CHECK(speed_at(expected_motion(opponent, {}, params), 0.9) == Approx(1.6));
  opponent.acceleration_mps2 = {0.0, 3.0};
  const double across_mps = 3.0 * params.acceleration_lasts_s;
  CHECK(speed_at(expected_motion(opponent, {}, params), 0.9) == Approx(std::hypot(1.5, across_mps)));
}

TEST_CASE("within 18 degrees of straight ahead it is speeding up, of straight back braking, else a turn") {
  const SafetyParams params;
  Opponent opponent{.velocity_mps = {1.5, 0.0}, .speed_max_mps = 1.5};
  const auto later_mps = [&](double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    opponent.acceleration_mps2 = 3.0 * Vec2(std::cos(angle), std::sin(angle));
    return speed_at(expected_motion(opponent, {}, params), 0.95);
  };
  for (const double side : {-1.0, 1.0}) {
    CHECK(later_mps(side * 15.0) == 1.5);
    CHECK(later_mps(side * 22.0) > 2.0);
    CHECK(later_mps(side * 158.0) > 0.5);
    CHECK(later_mps(side * 165.0) == 0.0);
  }
}

TEST_CASE("a top speed is nothing to who brakes") {
  Opponent opponent{.velocity_mps = {1.5, 0.0}, .acceleration_mps2 = {-3.0, 0.0}, .speed_max_mps = 1.0};
  CHECK(speed_at(expected_motion(opponent, {}, SafetyParams{}), 0.25) == Approx(0.75));
  CHECK(speed_at(expected_motion(opponent, {}, SafetyParams{}), 0.9) == 0.0);
}

TEST_CASE("nobody is expected to accelerate or brake where that lasts no time") {
  SafetyParams params;
  params.acceleration_lasts_s = 0.0;
  params.speeding_up_lasts_s = 0.0;
  Opponent opponent{.velocity_mps = {1.5, 0.0}, .speed_max_mps = 3.0};
  for (const Vec2& acceleration : {Vec2(3.0, 0.0), Vec2(-3.0, 0.0), Vec2(0.0, 3.0)}) {
    opponent.acceleration_mps2 = acceleration;
    CHECK(speed_at(expected_motion(opponent, {}, params), 0.9) == 1.5);
  }
  params.speeding_up_lasts_s = 0.6;
  opponent.acceleration_mps2 = {-3.0, 0.0};
  CHECK(speed_at(expected_motion(opponent, {}, params), 0.9) == 1.5);
}

TEST_CASE("who speeds up into another opponent does not speed up until then") {
  Opponent opponent{.velocity_mps = {1.5, 0.0}, .acceleration_mps2 = {3.0, 0.0}, .speed_max_mps = 3.0};
  const Motion motion = expected_motion(opponent, {.at_s = 0.3, .change_mps = {-1.0, 0.0}}, SafetyParams{});
  CHECK(speed_at(motion, 0.29) == 1.5);
  CHECK(speed_at(motion, 0.31) == Approx(0.5));
}

}  // namespace
}  // namespace regista
