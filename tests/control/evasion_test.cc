// Evading opponents: motions that last reach what one period cannot, and what robots choose where no margin can be
// kept.
#include <catch2/catch.hpp>
#include <optional>

#include "control/safety/motion.h"
#include "control/safety/opponent_models.h"
#include "control/safety/safety_search.h"
#include "tests/control/ideal_team.h"
#include "world_model/types/crash_rule.h"

namespace regista {
namespace {

using test::Dice;

constexpr double kPeriod_s = 0.01;

/// Robots choose once among opponents.
Vec2 choice(const SafetyRobot& robot, std::span<const Opponent> opponents, const SafetyParams& params) {
  SafetySearch search;
  Surroundings around;
  around.half_extent_m = {100.0, 100.0};
  std::vector<Vec2> chosen;
  search.choose(std::span(&robot, 1), opponents, around, RobotLimits{}, params, kPeriod_s, chosen);
  return chosen.front();
}

TEST_CASE("a motion kept up never exceeds the speed limit, asks for no more, and turns at top speed") {
  Dice dice(51);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 position = dice.point(3, 3);
    const Vec2 velocity = clamped_norm(dice.point(3, 3), 2.9);
    const Vec2 acceleration = dice.point(4, 4);
    const double hold_s = i % 3 == 0 ? kPeriod_s : 0.4;
    const Motion motion = sustained(position, velocity, acceleration, hold_s, 3.0, kPeriod_s, 1.0);
    INFO("motion " << i << " of seed 51");
    REQUIRE(motion.phases().size() == 3);
    const Phase& coast = motion.phases()[1];
    CHECK(coast.begin_s == hold_s);
    CHECK(coast.velocity_mps.norm() <= 3.0 + 1e-12);
    CHECK(coast.acceleration_mps2 == Vec2(Vec2::Zero()));
    CHECK(motion.phases()[0].acceleration_mps2.norm() <= acceleration.norm() + 1e-9);
    const Vec2 unlimited = velocity + hold_s * acceleration;
    if (unlimited.norm() <= 3.0) CHECK((coast.velocity_mps - unlimited).norm() <= 1e-12);
    CHECK(coast.velocity_mps.normalized().dot(unlimited.normalized()) >= 1.0 - 1e-12);
  }
  const Motion turn = sustained(Vec2::Zero(), {3, 0}, {0, 3}, 0.4, 3.0, kPeriod_s, 1.0);
  CHECK(turn.phases()[1].velocity_mps.y() > 1.0);
  // Shorter than a period there is nothing; faster than the limit, it may stay as fast.
  CHECK(sustained({0, 0}, {3.2, 0}, {3, 0}, 0.0, 3.0, kPeriod_s, 1.0).phases()[1].begin_s == kPeriod_s);
  CHECK(sustained({0, 0}, {3.2, 0}, {3, 0}, 0.4, 3.0, kPeriod_s, 1.0).phases()[1].velocity_mps.x() == Approx(3.2));
  CHECK(sustained({1, 2}, {0, 1}, Vec2::Zero(), 0.4, 3.0, kPeriod_s, 1.0).phases()[1].velocity_mps == Vec2(0, 1));
}

TEST_CASE("a robot also keeps clear of an opponent that may stop accelerating") {
  SafetyRobot robot;
  robot.velocity_mps = {2.0, 0.0};
  robot.wanted_mps = {2.0, 0.0};
  // Expected to turn off to the left; if it does not, it comes straight at us.
  const Opponent turns_off{{1.6, 0.0}, {-2.0, 0.0}, {0.0, 3.0}};
  OpponentModels models;
  models.set(std::span(&turns_off, 1), RobotLimits{}, SafetyParams{}, kPeriod_s);
  const Motion stops = braking(Vec2::Zero(), robot.velocity_mps, 0.0, 3.6, kPeriod_s);
  REQUIRE(models.is_clear_of_expected(stops));
  REQUIRE(models.is_clear_of_braking(stops));
  REQUIRE_FALSE(models.is_clear_of_expected(stops, Care::steady_too));
  const Vec2 chosen = choice(robot, std::span(&turns_off, 1), {});
  CHECK(chosen != robot.wanted_mps);
}

/// Ours at 2 m/s and an opponent at 1 m/s that drives on, nearly head on, too near to keep clear: the fault, if any.
std::optional<Fault> fault_of_meeting(const SafetyParams& params) {
  SafetyRobot robot;
  robot.velocity_mps = {2.0, 0.0};
  robot.wanted_mps = {2.0, 0.0};
  Opponent comes{{0.95, 0.02}, {-1.0, 0.0}, Vec2::Zero()};
  for (int period = 0; period < 60; ++period) {
    const Vec2 next_mps = choice(robot, std::span(&comes, 1), params);
    robot.position_m += kPeriod_s / 2.0 * (robot.velocity_mps + next_mps);
    robot.velocity_mps = next_mps;
    comes.position_m += kPeriod_s * comes.velocity_mps;
    const Vec2 apart = comes.position_m - robot.position_m;
    if (apart.norm() > 0.18) continue;
    return crash_fault(next_mps.dot(apart.normalized()), -comes.velocity_mps.dot(apart.normalized()));
  }
  return std::nullopt;
}

TEST_CASE("where a crash cannot be avoided any more, it is not our foul; who only brakes commits one") {
  CHECK(fault_of_meeting({}) == Fault::none);
  SafetyParams stubborn;
  stubborn.crash_horizon_s = 0.0;
  const std::optional<Fault> fault = fault_of_meeting(stubborn);
  REQUIRE(fault.has_value());
  CHECK((*fault == Fault::first || *fault == Fault::both));
}

TEST_CASE("too late for all margins a robot dodges") {
  SafetyRobot robot;
  robot.velocity_mps = {2.0, 0.0};
  robot.wanted_mps = {2.0, 0.0};
  const Opponent comes{{1.1, 0.13}, {-2.0, 0.0}, Vec2::Zero()};
  CHECK(choice(robot, std::span(&comes, 1), {}).y() < -0.005);
  SafetyParams stubborn;
  stubborn.crash_horizon_s = 0.0;
  CHECK(choice(robot, std::span(&comes, 1), stubborn).y() == Approx(0.0).margin(1e-12));
}

TEST_CASE("in the line of fire a robot goes aside at once instead of braking into it") {
  SafetyRobot robot;
  robot.velocity_mps = {1.0, 0.0};
  robot.wanted_mps = {1.0, 0.0};
  const Opponent fast{{1.6, 0.05}, {-2.0, 0.0}, Vec2::Zero()};
  const Vec2 chosen = choice(robot, std::span(&fast, 1), {});
  CHECK(chosen.y() < -0.015);
  // Kept up, that is clear of it.
  const Motion aside = sustained(Vec2::Zero(), robot.velocity_mps, (chosen - robot.velocity_mps) / kPeriod_s,
                                 SafetyParams{}.evasion_long_s, 3.0, kPeriod_s, 1.0);
  OpponentModels models;
  models.set(std::span(&fast, 1), RobotLimits{}, SafetyParams{}, kPeriod_s);
  CHECK(models.crash_cost(aside) == 0.0);
  SafetyParams never_lasting;
  never_lasting.evasion_short_s = 0.0;
  never_lasting.evasion_long_s = 0.0;
  never_lasting.crash_horizon_s = 0.0;
  CHECK(std::abs(choice(robot, std::span(&fast, 1), never_lasting).y()) < 0.01);
}

}  // namespace
}  // namespace regista
