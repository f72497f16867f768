#include "sim/command_link.h"

#include <catch2/catch.hpp>
#include <limits>
#include <stdexcept>

namespace regista {
namespace {

const std::vector<RobotId> kRobots{{Team::yellow, 0}, {Team::yellow, 5}, {Team::blue, 0}};

TeamCommands tell(Team team, std::uint16_t robot, double forward_mps) {
  RobotCommand command;
  command.robot = robot;
  command.velocity.forward_mps = forward_mps;
  TeamCommands commands;
  commands.team = team;
  commands.commands = {command};
  return commands;
}

TEST_CASE("a command acts exactly a latency after it arrived, and until the timeout") {
  RadioParams params;
  params.latency_s = 0.030;
  CommandLink link(kRobots, params, 1);
  link.receive(tell(Team::yellow, 5, 1.5), from_us(2000));
  link.update(from_us(31999));
  CHECK(link.heard(1, from_us(31999)) == nullptr);
  link.update(from_us(32000));
  REQUIRE(link.heard(1, from_us(32000)) != nullptr);
  CHECK(link.heard(1, from_us(32000))->velocity.forward_mps == 1.5);
  CHECK(link.heard(0, from_us(32000)) == nullptr);
  CHECK(link.heard(2, from_us(32000)) == nullptr);
  CHECK(link.heard(1, from_us(131999)) != nullptr);
  CHECK(link.heard(1, from_us(132000)) == nullptr);
}

TEST_CASE("the newest command wins, also when an older one arrives after it") {
  CommandLink link(kRobots, {}, 1);
  link.receive(tell(Team::blue, 0, 2.0), from_us(2000));
  link.receive(tell(Team::blue, 0, 1.0), from_us(1000));
  link.update(from_us(5000));
  CHECK(link.heard(2, from_us(5000))->velocity.forward_mps == 2.0);
  link.receive(tell(Team::blue, 0, 1.0), from_us(1000));
  link.update(from_us(6000));
  CHECK(link.heard(2, from_us(6000))->velocity.forward_mps == 2.0);
}

TEST_CASE("as many commands are lost as the parameter says") {
  RadioParams params;
  params.loss = 0.03;
  CommandLink link(kRobots, params, 3);
  int lost = 0;
  for (int i = 0; i < 20000; ++i) {
    link.receive(tell(Team::yellow, 0, i), from_us(i));
    link.update(from_us(i));
    const HeardCommand* heard = link.heard(0, from_us(i));
    lost += heard == nullptr || heard->velocity.forward_mps != i;
  }
  CHECK(lost / 20000.0 == Approx(0.03).margin(0.006));  // five standard errors
}

TEST_CASE("commands for robots that are not there move nobody") {
  CommandLink link(kRobots, {}, 1);
  link.receive(tell(Team::blue, 5, 1.0), Time{});
  link.update(Time{});
  for (std::size_t i = 0; i < kRobots.size(); ++i) CHECK(link.heard(i, Time{}) == nullptr);
}

TEST_CASE("a command that is not a number is refused with its value, and none of its team's is taken") {
  CommandLink link(kRobots, {}, 1);
  TeamCommands commands = tell(Team::yellow, 0, 1.0);
  commands.commands.push_back(tell(Team::yellow, 5, std::numeric_limits<double>::quiet_NaN()).commands[0]);
  CHECK_THROWS_WITH(link.receive(commands, Time{}), Catch::Contains("Y5") && Catch::Contains("nan"));
  commands = tell(Team::yellow, 0, 1.0);
  commands.commands[0].kick_speed_mps = -2.5;
  CHECK_THROWS_WITH(link.receive(commands, Time{}), Catch::Contains("Y0") && Catch::Contains("-2.5"));
  commands.commands[0].kick_speed_mps = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(link.receive(commands, Time{}), std::invalid_argument);
  link.update(Time{});
  CHECK(link.heard(0, Time{}) == nullptr);
}

}  // namespace
}  // namespace regista
