#include "sim/validators.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace regista {
namespace {

WorldState still_world() {
  WorldState world;
  world.robots.resize(2);
  world.robots[0].id = {Team::yellow, 2};
  world.robots[1].id = {Team::blue, 5};
  return world;
}

TEST_CASE("a clean run has no violations") {
  Scenario scenario;
  scenario.expect = {3, 0};
  Validation validation(validators_of(scenario, {}));
  const WorldState world = still_world();
  validation.observe({world, {}, 0, 0});
  validation.finish({world, {}, 3, 3});
  CHECK(validation.violations().empty());
}

TEST_CASE("the first violation of each kind is kept, with time, robot, value and bound") {
  Scenario scenario;
  scenario.expect = {3, 1};
  Validation validation(validators_of(scenario, {}));
  WorldState world = still_world();
  world.captured = from_us(20'000);
  world.robots[1].pose.position_m = {0.0, -4.75};
  validation.observe({world, {}, 0, 0});
  world.captured = from_us(30'000);
  world.robots[0].pose.position_m = {7.0, 0.0};
  world.robots[0].twist.velocity_mps = {0.0, 3.5};
  validation.observe({world, {2, 0, 0, 0, 0}, 0, 0});
  validation.finish({world, {2, 0, 0, 0, 0}, 3, 2});

  const auto& seen = validation.violations();
  REQUIRE(seen.size() == 4);
  CHECK(seen[0] == Violation{"inside the field", from_us(20'000), RobotId{Team::blue, 5}, 4.75, 4.8 - 0.09, "m"});
  CHECK(seen[1] == Violation{"speed limits", from_us(30'000), RobotId{Team::yellow, 2}, 3.5, 3.0, "m/s"});
  CHECK(seen[2] == Violation{"contacts inside teams", from_us(30'000), std::nullopt, 2.0, 1.0, ""});
  CHECK(seen[3] == Violation{"targets reached by blue", from_us(30'000), std::nullopt, 2.0, 3.0, ""});
  CHECK(to_string(seen[1]) == "speed limits violated at 0.03 s by Y2: 3.5 against 3 m/s");
}

TEST_CASE("a number that is none is a violation") {
  Validation validation({inside_field(division_a(), 0.09), within_speed_limits({})});
  WorldState world = still_world();
  world.robots[0].pose.position_m.x() = std::nan("");
  world.robots[0].twist.angular_radps = std::nan("");
  validation.observe({world, {}, 0, 0});
  CHECK(validation.violations().size() == 2);
}

TeamCommands told(Team team, std::uint16_t robot, const BodyVelocity& velocity) {
  TeamCommands commands;
  commands.team = team;
  commands.commands.resize(1);
  commands.commands[0].robot = robot;
  commands.commands[0].velocity = velocity;
  return commands;
}

// What a scenario's validators say to commands that the simulator would cut before they show in the truth.
std::vector<Violation> judged(const std::vector<TeamCommands>& commands) {
  Validation validation(validators_of(Scenario{}, {}));
  const WorldState world = still_world();
  validation.observe({world, {}, 0, 0, commands});
  return validation.violations();
}

TEST_CASE("a controller that commands more than a robot can do is caught") {
  CHECK(judged({told(Team::yellow, 2, {3.0, 0.0, 10.0}), told(Team::blue, 5, {1.8, -2.4, -10.0})}).empty());
  const auto seen = judged({told(Team::yellow, 2, {1.0, 0.0, 0.0}), told(Team::blue, 5, {50.0, 0.0, 0.0})});
  REQUIRE(seen.size() == 1);
  CHECK(seen[0] == Violation{"commands within limits", Time{}, RobotId{Team::blue, 5}, 50.0, 3.0, "m/s"});
  CHECK(judged({told(Team::yellow, 2, {2.5, 2.5, 0.0})}).size() == 1);  // each axis is, both together are not
  CHECK(judged({told(Team::yellow, 2, {0.0, 0.0, -10.1})}).size() == 1);
  CHECK(judged({told(Team::yellow, 2, {std::nan(""), 0.0, 0.0})}).size() == 1);
}

// Y2 is at `path[i]` for a second each, seen a hundred times per second.
std::vector<Violation> stayed(const std::vector<Vec2>& path) {
  Validation validation(validators_of(Scenario{}, {}));
  WorldState world = still_world();
  for (const Vec2& place : path) {
    world.robots[0].pose.position_m = place;
    for (int i = 0; i < 100; ++i) {
      validation.observe({world, {}});
      world.captured += Duration{10'000};
    }
  }
  return validation.violations();
}

TEST_CASE("a robot that stays in a defence area where it did not begin is caught") {
  const Vec2 outside(0.0, 1.0);
  for (const double side : {-1.0, 1.0}) {
    const Vec2 inside(side * 4.3, 1.7);  // the front is at 4.2 m, the side at 1.8 m
    CHECK(stayed({inside, inside, inside, inside}).empty());
    CHECK(stayed({outside, inside, inside, outside, inside, inside}).empty());
    const auto seen = stayed({outside, inside, inside, inside});
    REQUIRE(seen.size() == 1);
    CHECK(seen[0].validator == "defence areas kept");
    CHECK(seen[0].at == from_us(3'010'000));
    CHECK(seen[0].robot == RobotId{Team::yellow, 2});
    CHECK(seen[0].value == Approx(2.01));
    CHECK(seen[0].bound == Approx(2.0));
    CHECK(stayed({inside, outside, inside, inside, inside}).size() == 1);  // it may stay only until it leaves
    for (const Vec2& partly : {Vec2(side * 4.28, 0.0), Vec2(side * 5.0, 1.72), Vec2(side * 6.05, 0.0)}) {
      CHECK(stayed({outside, partly, partly, partly, partly}).empty());
    }
  }
}

TEST_CASE("contacts between the teams are judged where the scenario asks for it") {
  Scenario scenario;
  const WorldState world = still_world();
  for (const std::int64_t count_max : {-1, 2, 3}) {
    scenario.expect.opponent_contacts_max = count_max;
    Validation validation(validators_of(scenario, {}));
    validation.observe({world, {0, 0, 3, 0, 0}});
    CHECK(validation.violations().size() == (count_max == 2 ? 1 : 0));
  }
}

}  // namespace
}  // namespace regista
