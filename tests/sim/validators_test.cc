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

}  // namespace
}  // namespace regista
