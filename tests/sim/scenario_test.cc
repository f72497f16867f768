#include "sim/scenario.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "sim/simulator.h"

namespace regista {
namespace {

void check_formation(const FieldGeometry& field, int robots, double radius_m) {
  INFO(robots << " robots on " << field.length_m << " x " << field.width_m);
  const auto placements = formation(field, robots, radius_m);
  REQUIRE(placements.size() == 2 * static_cast<std::size_t>(robots));
  for (std::size_t i = 0; i < placements.size(); ++i) {
    const RobotPlacement& placement = placements[i];
    const auto number = static_cast<std::uint16_t>(i % static_cast<std::size_t>(robots));
    REQUIRE(placement.id == RobotId{i < placements.size() / 2 ? Team::yellow : Team::blue, number});
    const double side = defends_negative_x(placement.id.team, field) ? -1.0 : 1.0;
    const Vec2& position = placement.pose.position_m;
    const double towards_goal = side * position.x();
    REQUIRE(towards_goal >= radius_m);  // own half
    REQUIRE(towards_goal <= field.length_m / 2.0 - radius_m);
    REQUIRE(std::abs(position.y()) <= field.width_m / 2.0 - radius_m);
    REQUIRE(std::cos(placement.pose.heading_rad) * side == Approx(-1.0));  // looks at the other goal
    const double area_x = field.length_m / 2.0 - field.defence_depth_m;
    const double area_y = field.defence_width_m / 2.0;
    if (number == 0) {
      REQUIRE(towards_goal >= area_x + radius_m);
      REQUIRE(std::abs(position.y()) <= area_y - radius_m);
    } else {
      const bool outside = towards_goal < area_x - radius_m || std::abs(position.y()) > area_y + radius_m;
      REQUIRE(outside);
    }
    for (std::size_t j = 0; j < i; ++j) {
      REQUIRE((position - placements[j].pose.position_m).norm() > 2.0 * radius_m);
    }
  }
}

TEST_CASE("formations are legal in both divisions, for any number of robots that fits") {
  for (int robots = 1; robots <= 60; ++robots) {
    check_formation(division_a(), robots, 0.09);
    check_formation(division_b(), robots, 0.09);
  }
  FieldGeometry turned = division_b();
  turned.yellow_on_positive_x = true;
  check_formation(turned, 6, 0.09);
  FieldGeometry large;
  large.length_m = 60.0;
  large.width_m = 40.0;
  check_formation(large, 1000, 0.09);
}

TEST_CASE("too many robots are refused, with the number that fits") {
  std::string said;
  try {
    (void)formation(division_b(), 1000, 0.09);
  } catch (const std::invalid_argument& error) {
    said = error.what();
  }
  REQUIRE(said.find("at most ") != std::string::npos);
  const int most = std::stoi(said.substr(said.find("at most ") + 8));
  CHECK(most > 60);
  CHECK_NOTHROW(formation(division_b(), most, 0.09));
  CHECK_THROWS_AS(formation(division_b(), most + 1, 0.09), std::invalid_argument);
}

TEST_CASE("every preset constructs, an unknown one is answered with the list") {
  for (const std::string& preset : sim_preset_names()) {
    Scenario scenario;
    scenario.sim_preset = preset;
    Simulator simulator(sim_setup(scenario, Time{}));
    CHECK(simulator.truth().robots.size() == 22);
    CHECK(simulator.params() == sim_preset(preset));
  }
  CHECK(sim_preset("none") == SimParams{});
  for (const std::string& preset : sim_preset_names()) {
    CHECK_THROWS_WITH(sim_preset("nosy"), Catch::Contains("nosy") && Catch::Contains(preset));
  }
}

TEST_CASE("a scenario's mistakes are named") {
  CHECK_NOTHROW(validate(Scenario{}));
  const auto complains = [](const char* key, const char* text, const char* about) {
    Scenario scenario;
    set_param(scenario, key, text);
    CHECK_THROWS_WITH(validate(scenario), Catch::Contains(about));
  };
  complains("field.division", "C", "A, B or custom");
  complains("sim_preset", "loud", "realistic");
  complains("referee", "kick_off", "kick_off_blue");
  complains("task", "dance", "random_targets or stand");
  complains("target_distance_min_m", "7", "at most half");
  complains("robots_per_team", "1000", "at most");
  Scenario endless;
  endless.duration_s = std::nan("");
  CHECK_THROWS_WITH(validate(endless), Catch::Contains("duration_s"));
  Scenario arrived_at_once;
  arrived_at_once.arrival_m = 0.5;
  arrived_at_once.target_distance_min_m = 0.4;
  CHECK_THROWS_WITH(validate(arrived_at_once), Catch::Contains("arrival_m"));
}

TEST_CASE("every field of a scenario and of the parameters can be listed and set") {
  Scenario scenario;
  for (const ParamInfo& info : list_params(scenario)) {
    INFO(info.key);
    CHECK_NOTHROW(set_param(scenario, info.key, info.value));
    CHECK_FALSE(info.help.empty());
  }
  CHECK(scenario == Scenario{});
  SimParams params = sim_preset("realistic");
  for (const ParamInfo& info : list_params(params)) {
    INFO(info.key);
    CHECK_NOTHROW(set_param(params, info.key, info.value));
  }
  CHECK(params == sim_preset("realistic"));
  set_param(params, "limits.speed_max_mps", "2.5");
  CHECK(params.limits.speed_max_mps == 2.5);
}

TEST_CASE("a custom field takes its lengths") {
  Scenario scenario;
  scenario.field = {"custom", 60.0, 40.0, true};
  scenario.robots_per_team = 1000;
  CHECK(field_of(scenario).length_m == 60.0);
  const auto placements = initial_placements(scenario);
  CHECK(placements.size() == 2000);
  CHECK(placements[0].pose.position_m.x() > 0.0);
}

}  // namespace
}  // namespace regista
