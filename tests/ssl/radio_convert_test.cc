#include <catch2/catch.hpp>
#include <limits>
#include <numbers>

#include "modules/convert/message.h"
#include "modules/ssl/packet.h"
#include "modules/ssl/ssl_radio_convert.h"
#include "ssl_simulation_control.pb.h"
#include "ssl_simulation_response.pb.h"
#include "tests/ssl/protoc.h"

using namespace regista;

namespace {

regista::RobotCommand some_command() {
  regista::RobotCommand command;
  command.robot = 3;
  command.velocity = {1.5, -0.25, 2.0};
  command.kick_speed_mps = 4.0;
  command.dribbler_radps = 2.0 * std::numbers::pi * 10.0;
  return command;
}

}  // namespace

TEST_CASE("commands as protoc reads them: local velocity, m/s, rad/s, turns per minute") {
  regista::RobotCommand standing;
  standing.robot = 15;
  const std::string bytes = to_robot_control({some_command(), standing}).SerializeAsString();
  CHECK(protoc_decode("ssl_simulation_control.proto", "RobotControl", bytes) == R"(robot_commands {
  id: 3
  move_command {
    local_velocity {
      forward: 1.5
      left: -0.25
      angular: 2
    }
  }
  kick_speed: 4
  dribbler_speed: 600
}
robot_commands {
  id: 15
  move_command {
    local_velocity {
      forward: 0
      left: 0
      angular: 0
    }
  }
  dribbler_speed: 0
}
)");
}

TEST_CASE("commands carry the league's field numbers") {
  const std::string bytes = to_robot_control({some_command()}).SerializeAsString();
  CHECK(protoc_decode_raw(bytes) == R"(1 {
  1: 3
  2 {
    2 {
      1: 0x3fc00000
      2: 0xbe800000
      3: 0x40000000
    }
  }
  3: 0x40800000
  5: 0x44160000
}
)");
}

TEST_CASE("no commands are an empty datagram") { CHECK(to_robot_control({}).SerializeAsString().empty()); }

TEST_CASE("commands that no robot can follow are refused") {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300}) {
    CAPTURE(bad);
    for (const auto member : {&BodyVelocity::forward_mps, &BodyVelocity::left_mps, &BodyVelocity::angular_radps}) {
      regista::RobotCommand command = some_command();
      command.velocity.*member = bad;
      CHECK_THROWS_AS(to_robot_control({command}), MessageError);
    }
    regista::RobotCommand command = some_command();
    command.kick_speed_mps = bad;
    CHECK_THROWS_AS(to_robot_control({command}), MessageError);
    command = some_command();
    command.dribbler_radps = bad;
    CHECK_THROWS_AS(to_robot_control({command}), MessageError);
  }
}

TEST_CASE("errors become one line each") {
  const std::string bytes = protoc_encode("ssl_simulation_response.proto", "RobotControlResponse", R"(
    errors { code: "VELOCITY_TYPE" message: "only local\nvelocity" }
    errors { code: "UNKNOWN_ID" }
    errors { message: "no code" }
    errors { }
    feedback { id: 3 dribbler_ball_contact: true })");
  const auto lines = error_lines(parse_packet<::RobotControlResponse>(as_bytes(bytes)));
  CHECK(lines ==
        std::vector<std::string>{"VELOCITY_TYPE: only local velocity", "UNKNOWN_ID", "error: no code", "error"});
}
