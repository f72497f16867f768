// What a crash with an opponent costs a motion: most where it is our foul and near, and of several only the worst.
#include <catch2/catch.hpp>

#include "control/safety/opponent_models.h"

namespace regista {
namespace {

constexpr double kPeriod_s = 0.01;

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

}  // namespace
}  // namespace regista
