// Expectations of opponents: what is clear of them by sampling, who brakes is expected to stand, standing ones keep
// their margin, and evasions that last reach what one period cannot.
#include "control/safety/opponent_models.h"

#include <catch2/catch.hpp>
#include <optional>

#include "control/safety/safety_search.h"
#include "tests/control/ideal_team.h"
#include "world_model/types/crash_rule.h"

namespace regista {
namespace {

using test::Dice;

constexpr double kPeriod_s = 0.01;

Vec2 place_at(const Motion& motion, double time_s) {
  const Phase& phase = motion.phase_at(time_s);
  return position_after(phase, time_s - phase.begin_s);
}

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

TEST_CASE("clear of where an opponent is expected means what dense samples say") {
  Dice dice(52);
  const RobotLimits limits;
  const SafetyParams params;
  int clear = 0;
  for (int i = 0; i < 2000; ++i) {
    const Opponent other{dice.point(1.5, 1.5), dice.point(2, 2), dice.point(3, 3)};
    const Motion ours(Vec2::Zero(), dice.point(2, 2));
    if (other.position_m.norm() < 0.3) continue;
    OpponentModels models;
    models.set(std::span(&other, 1), limits, params, kPeriod_s);
    const double speed = other.velocity_mps.norm();
    const double against = -other.acceleration_mps2.dot(other.velocity_mps);
    if (against > 0.0) continue;  // the next test's
    Motion theirs(other.position_m, other.velocity_mps);
    theirs.then(other.acceleration_mps2, params.acceleration_lasts_s);
    double least_m = 1e9;  // beyond the gap
    for (double t = 0.0; t <= params.horizon_s; t += 1e-3) {
      const double gap_m = 2.0 * limits.radius_m + params.opponent_margin_m + params.opponent_growth * speed * t;
      least_m = std::min(least_m, (place_at(ours, t) - place_at(theirs, t)).norm() - gap_m);
    }
    INFO("pair " << i << " of seed 52");
    if (std::abs(least_m) > 5e-3) CHECK(models.is_clear_of_expected(ours) == (least_m > 0.0));
    clear += least_m > 0.0 ? 1 : 0;
  }
  CHECK(clear > 300);
}

TEST_CASE("who is seen to brake is expected to stand, not to drive on after a while") {
  const Motion stands(Vec2::Zero(), Vec2::Zero());
  OpponentModels models;
  // 3 m/s and 4 m/s² need 1.125 m; 0.3 s of braking and driving on reach 2.0 m within the horizon.
  const Opponent brakes{{1.7, 0.0}, {-3.0, 0.0}, {4.0, 0.0}};
  models.set(std::span(&brakes, 1), RobotLimits{}, SafetyParams{}, kPeriod_s);
  CHECK(models.is_clear_of_expected(stands));
  CHECK(models.crash_cost(stands) == 0.0);
  const Opponent drives{{1.7, 0.0}, {-3.0, 0.0}, Vec2::Zero()};
  models.set(std::span(&drives, 1), RobotLimits{}, SafetyParams{}, kPeriod_s);
  CHECK_FALSE(models.is_clear_of_expected(stands));
  CHECK(models.crash_cost(stands) > 0.0);
}

/// Of driving straight at an opponent that comes with that speed from 1 m away.
double cost_of_meeting(double speed_mps, double opponent_mps, double horizon_s = SafetyParams{}.crash_horizon_s) {
  const Opponent comes{{1.0, 0.0}, {-opponent_mps, 0.0}, Vec2::Zero()};
  SafetyParams params;
  params.crash_horizon_s = horizon_s;
  OpponentModels models;
  models.set(std::span(&comes, 1), RobotLimits{}, params, kPeriod_s);
  return models.crash_cost(Motion(Vec2::Zero(), {speed_mps, 0.0}));
}

TEST_CASE("a crash costs more when it would be our foul, when it is nearer, and none when it is too far ahead") {
  const double ours = cost_of_meeting(2.0, 1.0);
  const double theirs = cost_of_meeting(1.0, 2.0);
  const double slow = cost_of_meeting(0.5, 0.4);
  CHECK(ours > 0.5);
  CHECK(theirs > slow);
  CHECK(slow > 0.0);
  CHECK(theirs < ours / 2);
  CHECK(cost_of_meeting(1.9, 2.0) > 2.0 * theirs);   // both are guilty
  CHECK(cost_of_meeting(1.0, 0.45) > 2.0 * theirs);  // 1.45 m/s: no crash yet
  CHECK(cost_of_meeting(1.0, 0.2) > 1.5 * theirs);   // nearly one
  CHECK(cost_of_meeting(1.0, 0.05) < theirs);        // not even nearly
  CHECK(cost_of_meeting(3.0, 0.0) > cost_of_meeting(2.0, 0.0));
  // 0.8 m at 3 m/s.
  CHECK(cost_of_meeting(2.0, 1.0, 0.26) == 0.0);
  CHECK(cost_of_meeting(2.0, 1.0, 0.28) > 0.0);
  CHECK(cost_of_meeting(2.0, 1.0, 0.0) == 0.0);
  CHECK(cost_of_meeting(2.0, 1.0, 2.0) > ours);
  CHECK(cost_of_meeting(-2.0, -1.0) == 0.0);
}

TEST_CASE("who is about to hit another opponent is expected to go on with it, and not foreseen too far ahead") {
  // Towards each other along x, 0.3 s before they touch, both drifting in y: there they stay in x.
  const std::vector<Opponent> pair{{{-0.39, 0.0}, {1.0, 1.0}, Vec2::Zero()}, {{0.39, 0.0}, {-1.0, 1.0}, Vec2::Zero()}};
  const Motion where_one_would_be({0.4, 0.8}, Vec2::Zero());
  const Motion where_both_will_be({0.0, 0.8}, Vec2::Zero());
  OpponentModels models;
  models.set(pair, RobotLimits{}, SafetyParams{}, kPeriod_s);
  CHECK(models.is_clear_of_expected(where_one_would_be));
  CHECK_FALSE(models.is_clear_of_expected(where_one_would_be, Care::steady_too));
  CHECK_FALSE(models.is_clear_of_expected(where_both_will_be));
  const std::vector<Opponent> late{{{-1.0, 0.0}, {1.0, 1.0}, Vec2::Zero()}, {{1.0, 0.0}, {-1.0, 1.0}, Vec2::Zero()}};
  SafetyParams far;
  far.horizon_s = 2.0;
  models.set(late, RobotLimits{}, far, kPeriod_s);
  CHECK_FALSE(models.is_clear_of_expected(Motion({0.5, 1.5}, Vec2::Zero())));
  std::vector<Touch> touches;
  foresee_touches(late, 0.18, 0.6, touches);
  CHECK(touches == std::vector<Touch>(2));
  foresee_touches(late, 0.18, 1.0, touches);
  CHECK(touches[0].at_s == Approx(0.91));
}

TEST_CASE("a neighbour beside an opponent hides neither its acceleration nor its braking") {
  const Opponent neighbour{{0.0, 0.19}, Vec2::Zero(), Vec2::Zero()};
  const Opponent starts{{0.0, 0.0}, {0.0, 0.02}, {3.0, 0.0}};
  const Opponent brakes{{0.0, 0.0}, {1.0, 0.02}, {-4.0, -0.08}};
  for (const std::vector<Opponent>& around : {std::vector<Opponent>{}, std::vector<Opponent>{neighbour}}) {
    OpponentModels models;
    std::vector<Opponent> all{starts};
    all.insert(all.end(), around.begin(), around.end());
    models.set(all, RobotLimits{}, SafetyParams{}, kPeriod_s);
    CHECK_FALSE(models.is_clear_of_expected(Motion({0.6, 0.0}, Vec2::Zero())));
    CHECK(models.crash_cost(Motion({0.6, 0.0}, Vec2::Zero())) > 0.0);
    all[0] = brakes;
    models.set(all, RobotLimits{}, SafetyParams{}, kPeriod_s);
    CHECK(models.is_clear_of_expected(Motion({0.9, 0.0}, Vec2::Zero())));
  }
}

TEST_CASE("margins grow on the way") {
  const auto is_clear = [](double beside_m) {
    const Opponent passes{{-0.9, beside_m}, {1.0, 0.0}, Vec2::Zero()};
    OpponentModels models;
    models.set(std::span(&passes, 1), RobotLimits{}, SafetyParams{}, kPeriod_s);
    return models.is_clear_of_expected(Motion(Vec2::Zero(), Vec2::Zero()));
  };
  // After 0.9 s: bodies 0.18, margin 0.02, grown by 0.054.
  CHECK_FALSE(is_clear(0.245));
  CHECK(is_clear(0.265));
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

TEST_CASE("a foreseen touch is the first; if for both, it keeps the momentum and leaves no speed towards each other") {
  Dice dice(53);
  int touched = 0;
  for (int i = 0; i < 500; ++i) {
    const std::vector<Opponent> all{{dice.point(1, 1), dice.point(2, 2), Vec2::Zero()},
                                    {dice.point(1, 1), dice.point(2, 2), Vec2::Zero()},
                                    {dice.point(1, 1), dice.point(2, 2), Vec2::Zero()}};
    std::vector<Touch> touches;
    foresee_touches(all, 0.18, 0.6, touches);
    INFO("three of round " << i << " of seed 53");
    for (std::size_t a = 0; a < all.size(); ++a) {
      double first_s = kNever;
      for (std::size_t b = 0; b < all.size(); ++b) {
        if (b == a) continue;
        const Vec2 apart = all[b].position_m - all[a].position_m;
        const Vec2 velocity = all[b].velocity_mps - all[a].velocity_mps;
        for (double t = 0.0; t <= 0.6; t += 1e-3) {
          const bool approach = (apart + t * velocity).dot(velocity) < 0.0;
          if (approach && (apart + t * velocity).norm() < 0.18) first_s = std::min(first_s, t);
        }
        if (touches[a].at_s != touches[b].at_s || touches[a].at_s == kNever) continue;
        CHECK((touches[a].change_mps + touches[b].change_mps).norm() <= 1e-12);
        const Vec2 normal = (apart + touches[a].at_s * velocity).normalized();
        CHECK(std::abs((velocity + touches[b].change_mps - touches[a].change_mps).dot(normal)) <= 1e-9);
        ++touched;
      }
      if (first_s < 0.599) CHECK(std::abs(touches[a].at_s - first_s) <= 2e-3);
      if (touches[a].at_s == kNever) CHECK(first_s >= 0.599);
    }
  }
  CHECK(touched > 100);
}

TEST_CASE("of several crashes the worst counts, whichever opponent comes first") {
  const Motion ours(Vec2::Zero(), {2.0, 0.0});
  const Opponent foul{{1.0, 0.0}, {-1.0, 0.0}, Vec2::Zero()};
  const Opponent no_foul{{-0.5, 0.0}, {2.5, 0.0}, Vec2::Zero()};
  const auto cost_of = [&](const std::vector<Opponent>& opponents) {
    OpponentModels models;
    models.set(opponents, RobotLimits{}, SafetyParams{}, kPeriod_s);
    return models.crash_cost(ours);
  };
  REQUIRE(cost_of({foul}) > cost_of({no_foul}));
  REQUIRE(cost_of({no_foul}) > 0.0);
  CHECK(cost_of({foul, no_foul}) == cost_of({foul}));
  CHECK(cost_of({no_foul, foul}) == cost_of({foul}));
}

TEST_CASE("the margin to an opponent's braking grows with its speed") {
  const auto is_clear = [](double beside_m) {
    const Opponent passes{{-0.5, beside_m}, {3.0, 0.0}, Vec2::Zero()};
    OpponentModels models;
    models.set(std::span(&passes, 1), RobotLimits{}, SafetyParams{}, kPeriod_s);
    return models.is_clear_of_braking(Motion(Vec2::Zero(), Vec2::Zero()));
  };
  // Bodies 0.18, margin 0.02, 0.018 s at 3 m/s.
  CHECK_FALSE(is_clear(0.25));
  CHECK(is_clear(0.26));
}

TEST_CASE("where both braking leave less than that, half of it is kept for the opponent") {
  const Opponent passes{{-0.5, 0.25}, {3.0, 0.0}, Vec2::Zero()};
  OpponentModels models;
  models.set(std::span(&passes, 1), RobotLimits{}, SafetyParams{}, kPeriod_s);
  const Motion standing(Vec2::Zero(), Vec2::Zero());
  CHECK_FALSE(models.is_clear_of_braking(standing));
  models.set_robot(standing);
  CHECK(models.is_clear_of_braking(standing));
  // 0.05 are left, and the opponent cannot use more than 0.054: half is 0.027, rounded up.
  const auto nearer_by = [](double way_m) {
    Motion motion(Vec2::Zero(), {0.0, 2.0 * way_m / kPeriod_s});
    motion.then_stand({0.0, -2.0 * way_m / (kPeriod_s * kPeriod_s)}, kPeriod_s);
    return motion;
  };
  CHECK(models.is_clear_of_braking(nearer_by(0.02)));
  CHECK_FALSE(models.is_clear_of_braking(nearer_by(0.03)));
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
