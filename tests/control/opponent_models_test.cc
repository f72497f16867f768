// Expectations of opponents: what is clear of them by sampling, who brakes is expected to stand, standing ones keep
// their margin.
#include "control/safety/opponent_models.h"

#include <catch2/catch.hpp>

#include "control/safety/opponent_touches.h"
#include "tests/control/ideal_team.h"

namespace regista {
namespace {

using test::Dice;

constexpr double kPeriod_s = 0.01;

Vec2 place_at(const Motion& motion, double time_s) {
  const Phase& phase = motion.phase_at(time_s);
  return position_after(phase, time_s - phase.begin_s);
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

TEST_CASE("of who drives and is about to touch another opponent so much more room is kept, of who stands there none") {
  OpponentModels models;
  // A partner to the right comes nearer by 0.1 m/s and touches after partner_s, or there is none.
  const auto is_clear = [&](const Vec2& ours_m, double speed_mps, double partner_s, Care care = Care::margins) {
    std::vector<Opponent> all{{{0.0, 0.0}, {speed_mps, 0.0}, Vec2::Zero()}};
    if (partner_s < kNever) {
      const Vec2 there(0.0, -2.0 * RobotLimits{}.radius_m - 0.1 * partner_s);
      all.push_back({there, {speed_mps, 0.1}, Vec2::Zero()});
    }
    models.set(all, RobotLimits{}, SafetyParams{}, kPeriod_s);
    return models.is_clear_of_expected(Motion(ours_m, Vec2::Zero()), care);
  };
  // It passes 0.5 m ahead after 0.5 s with 0.2 m for bodies and margin, 0.03 m for its way, 0.1 m for being jostled.
  CHECK(is_clear({0.5, 0.25}, 1.0, kNever));
  CHECK(is_clear({0.5, 0.25}, 1.0, 0.25));
  CHECK_FALSE(is_clear({0.5, 0.33}, 1.0, 0.15));
  CHECK(is_clear({0.5, 0.36}, 1.0, 0.15));
  CHECK(is_clear({0.5, 0.36}, 1.0, 0.15, Care::steady_too));
  CHECK_FALSE(is_clear({0.0, 0.25}, 0.35, 0.15));
  CHECK(is_clear({0.0, 0.25}, 0.25, 0.15));
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

}  // namespace
}  // namespace regista
