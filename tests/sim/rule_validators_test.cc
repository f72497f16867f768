#include "sim/rule_validators.h"

#include <catch2/catch.hpp>

namespace regista {
namespace {

constexpr double kRadius_m = 0.09;

/// Y2 at that place with that speed for three seconds, the ball in the centre.
std::vector<Violation> judged(Validator validator, const Vec2& place_m, double speed_mps = 0.0,
                              Team team = Team::yellow) {
  Validation validation({std::move(validator)});
  WorldState world;
  world.ball = BallState{};
  world.robots.resize(1);
  world.robots[0].id = {team, 2};
  world.robots[0].pose.position_m = place_m;
  world.robots[0].twist.velocity_mps = {0.0, speed_mps};
  for (int i = 0; i < 300; ++i, world.captured += Duration{10'000}) validation.observe({world, {}});
  return validation.violations();
}

TEST_CASE("too fast in stop, but only after the grace") {
  CHECK(judged(stop_speed_kept(), {1, 1}, 1.49).empty());
  const auto seen = judged(stop_speed_kept(), {1, 1}, 1.51);
  REQUIRE(seen.size() == 1);
  CHECK(seen[0] == Violation{"speed in stop", Time{kRuleGrace}, RobotId{Team::yellow, 2}, 1.51, 1.5, "m/s"});
}

TEST_CASE("at halt nobody moves") {
  CHECK(judged(halt_kept(), {1, 1}).empty());
  CHECK(judged(halt_kept(), {1, 1}, 0.06).size() == 1);
}

TEST_CASE("too near to the ball, unless exempt") {
  const Validator all = ball_distance_kept(std::nullopt, kRadius_m, Grace::at_first);
  CHECK(judged(all, {0.612, 0.0}).empty());
  CHECK(judged(all, {0.611, 0.0}).size() == 1);
  CHECK(judged(ball_distance_kept(Team::yellow, kRadius_m, Grace::at_first), {0.3, 0.0}).empty());
  CHECK(judged(ball_distance_kept(Team::yellow, kRadius_m, Grace::at_first), {0.3, 0.0}, 0.0, Team::blue).size() == 1);
}

TEST_CASE("a ball that rolls towards a robot gives it two seconds each time") {
  const auto judged_with = [](Grace grace, double away_s) {
    Validation validation({ball_distance_kept(std::nullopt, kRadius_m, grace)});
    WorldState world;
    world.ball = BallState{};
    world.robots.resize(1);
    for (int i = 0; i < 600; ++i, world.captured += Duration{10'000}) {
      // Away at first, then near, with one pause in the middle of the last four seconds.
      const double t = 0.01 * i;
      const bool away = t < 2.0 || std::abs(t - 3.9) < away_s / 2.0;
      world.robots[0].pose.position_m = {away ? 2.0 : 0.3, 0.0};
      validation.observe({world, {}});
    }
    return validation.violations().size();
  };
  CHECK(judged_with(Grace::each_stay, 0.5) == 0);
  CHECK(judged_with(Grace::each_stay, 0.0) == 1);
  CHECK(judged_with(Grace::at_first, 0.5) == 1);
}

TEST_CASE("too near to the line of a placement") {
  const Validator line = placement_kept(Team::blue, {4.0, 0.0}, kRadius_m, Grace::at_first);
  CHECK(judged(line, {2.0, 0.591}).empty());
  CHECK(judged(line, {2.0, 0.589}).size() == 1);
  CHECK(judged(line, {4.591, 0.0}).empty());
  CHECK(judged(line, {2.0, 0.0}, 0.0, Team::blue).empty());
}

TEST_CASE("too near to the other team's area, on the side it defends") {
  for (const bool yellow_right : {false, true}) {
    FieldGeometry field = division_a();
    field.yellow_on_positive_x = yellow_right;
    const double other = yellow_right ? -1.0 : 1.0;
    const Validator validator = area_distance_kept(field, kRadius_m, Grace::at_first);
    CHECK(judged(validator, {other * (4.2 - 0.291), 0.0}).empty());
    CHECK(judged(validator, {other * (4.2 - 0.289), 0.0}).size() == 1);
    CHECK(judged(validator, {other * 5.0, -(1.8 + 0.289)}).size() == 1);
    CHECK(judged(validator, {-other * 5.0, 0.0}).empty());
  }
}

TEST_CASE("a scenario's referee brings its judges") {
  Scenario scenario;
  CHECK(rule_validators(scenario, {}).empty());
  scenario.referee = "stop";
  CHECK(rule_validators(scenario, {}).size() == 3);
  scenario.referee = "ball_placement_blue";
  scenario.placement_m = {2.0, 0.0};
  const auto judges = rule_validators(scenario, {});
  REQUIRE(judges.size() == 1);
  CHECK(judged(judges[0], {1.0, 0.2}).size() == 1);
}

}  // namespace
}  // namespace regista
