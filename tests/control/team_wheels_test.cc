#include "control/team_wheels.h"

#include <catch2/catch.hpp>

#include "control/controller.h"

namespace regista {
namespace {

double front_left(const OmniWheels& wheels) { return wheels.speeds({1.0, 0.0, 0.0})[0]; }

TEST_CASE("single robots have wheels of their own, the others the common ones") {
  WheelGeometry common;
  common.wheel_radius_m = 0.03;
  const TeamWheels team(common, " 3: wheel_radius_m=0.06 ;12:front_bearing_rad=1.2 wheel_radius_m=0.015; ");
  const double usual = front_left(OmniWheels(common));
  CHECK(front_left(team.of(0)) == usual);
  CHECK(front_left(team.of(3)) == Approx(usual / 2.0));
  CHECK(front_left(team.of(12)) == Approx(-std::sin(1.2) / 0.015));
  CHECK(front_left(TeamWheels(common, "").of(3)) == usual);
}

TEST_CASE("what makes no sense is refused with the part that is wrong") {
  const auto refused = [](const std::string& text, const std::string& about) {
    CHECK_THROWS_WITH(TeamWheels({}, text), Catch::Contains(about));
    CHECK_THROWS_AS(TeamWheels({}, text), std::invalid_argument);
  };
  refused("3 hub_radius_m=0.07", "no colon");
  refused("Y3: hub_radius_m=0.07", "no robot number");
  refused("-1: hub_radius_m=0.07", "no robot number");
  refused("70000: hub_radius_m=0.07", "no robot number");
  refused("3: hub_radius_m", "field=value");
  refused("3: hub_radius=0.07", "hub_radius_m");
  refused("3: hub_radius_m=7", "3: hub_radius_m=7");
  refused("3: hub_radius_m=0.07; 3: hub_radius_m=0.06", "came before");
  refused("3: bearings_rad=0,0,0,0", "do not make a robot");
}

TEST_CASE("a controller commands every robot with its own wheels") {
  ControlParams params;
  params.robot_wheels = "2: wheel_radius_m=0.061";
  Controller controller(Team::blue, params);
  WorldState world;
  for (const std::uint16_t number : std::initializer_list<std::uint16_t>{1, 2}) {
    RobotState robot;
    robot.id = {Team::blue, number};
    robot.pose.position_m = {0.0, static_cast<double>(number)};
    robot.twist.velocity_mps = {1.0, 0.0};
    world.robots.push_back(robot);
  }
  const TeamCommands commands = controller.update(world, {}, 0.01);
  REQUIRE(commands.commands.size() == 2);
  CHECK(commands.commands[0].velocity == commands.commands[1].velocity);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(commands.commands[0].wheel_speeds_radps[i] == Approx(2.0 * commands.commands[1].wheel_speeds_radps[i]));
  }
  params.robot_wheels = "2: nonsense";
  CHECK_THROWS_AS(controller.set_params(params), std::invalid_argument);
  CHECK(controller.update(world, {}, 0.01).commands.size() == 2);
}

}  // namespace
}  // namespace regista
