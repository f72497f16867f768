// The radio module against a UDP port that stands for a simulator; protoc reads and writes its packets.
#include <catch2/catch.hpp>

#include "modules/convert/commands.h"
#include "modules/convert/service.h"
#include "modules/ssl/ssl_radio_module.h"
#include "tests/ssl/module_bench.h"
#include "tests/ssl/plain_udp.h"
#include "tests/ssl/protoc.h"

using namespace regista;
using namespace std::chrono_literals;

namespace {

constexpr int kPatience_ms = 5000;

TeamCommands commands_of(Team team, std::vector<std::uint16_t> robots) {
  TeamCommands out;
  out.team = team;
  for (const std::uint16_t robot : robots) {
    regista::RobotCommand command;
    command.robot = robot;
    command.velocity = {0.5, -1.25, 3.0};
    out.commands.push_back(command);
  }
  return out;
}

std::string moving(int robot, const std::string& forward, const std::string& left, const std::string& angular) {
  return "robot_commands {\n  id: " + std::to_string(robot) +
         "\n  move_command {\n    local_velocity {\n      forward: " + forward + "\n      left: " + left +
         "\n      angular: " + angular + "\n    }\n  }\n  dribbler_speed: 0\n}\n";
}

std::string driving(int robot) { return moving(robot, "0.5", "-1.25", "3"); }
std::string standing(int robot) { return moving(robot, "0", "0", "0"); }

std::string error_answer() {
  return protoc_encode("ssl_simulation_response.proto", "RobotControlResponse",
                       R"(errors { code: "VELOCITY_TYPE" message: "only local velocity" })");
}

struct Radio : TestBus {
  UdpServer yellow;
  UdpServer blue;
  SslRadioModule module;

  explicit Radio(const std::string& teams = "both") : module(bus, params(teams)) {}

  SslRadioParams params(const std::string& teams) const {
    SslRadioParams out;
    out.yellow_port = yellow.port();
    out.blue_port = blue.port();
    out.teams = teams;
    return out;
  }

  void tick() { module.tick(now); }

  void command(const TeamCommands& commands) {
    bus.publish(channels::commands(commands.team), commands);
    while (bus.handle(Duration::zero())) {
    }
    tick();
  }

  /// The next datagram as protoc reads it.
  static std::string heard(UdpServer& server) {
    const auto bytes = server.receive(kPatience_ms);
    return bytes ? protoc_decode("ssl_simulation_control.proto", "RobotControl", *bytes) : "nothing";
  }
  /// True when nothing waits. Loopback delivers within the call that sends, so none is on its way.
  static bool quiet(UdpServer& server) { return !server.receive(0); }
};

}  // namespace

TEST_CASE("each team's commands go to its port as local velocities") {
  Radio radio;
  radio.tick();
  CHECK(Radio::heard(radio.yellow).empty());
  CHECK(Radio::heard(radio.blue).empty());
  radio.command(commands_of(Team::yellow, {3}));
  CHECK(Radio::heard(radio.yellow) == driving(3));
  radio.command(commands_of(Team::blue, {0, 10}));
  CHECK(Radio::heard(radio.blue) == driving(0) + driving(10));
  CHECK(Radio::quiet(radio.yellow));
  CHECK(radio.module.note().empty());
}

TEST_CASE("silence stops the robots that were driven") {
  Radio radio;
  radio.command(commands_of(Team::yellow, {3, 5}));
  CHECK(Radio::heard(radio.yellow) == driving(3) + driving(5));
  for (int i = 0; i < 20; ++i) {
    radio.now = *radio.module.due();
    radio.tick();
    REQUIRE(Radio::heard(radio.yellow) == standing(3) + standing(5));
  }
  CHECK(radio.now == from_us(1'000'000) + 2s);
  radio.now += 1s;
  radio.tick();
  CHECK(Radio::heard(radio.yellow).empty());
}

TEST_CASE("a robot without command stands while the others drive") {
  Radio radio;
  radio.command(commands_of(Team::blue, {1, 2}));
  radio.command(commands_of(Team::blue, {2}));
  Radio::heard(radio.blue);
  while (const auto bytes = radio.blue.receive(0)) {
    CHECK(protoc_decode("ssl_simulation_control.proto", "RobotControl", *bytes) == driving(2) + standing(1));
  }
}

TEST_CASE("the port of a team that is not driven hears empty packets at least twice a second") {
  Radio radio("blue");
  int heard = 0;
  const Time end = radio.now + 2s;
  while (radio.now < end) {
    radio.command(commands_of(Team::blue, {0}));
    radio.command(commands_of(Team::yellow, {0}));
    REQUIRE_FALSE(Radio::quiet(radio.blue));
    while (const auto bytes = radio.yellow.receive(0)) {
      REQUIRE(bytes->empty());
      ++heard;
    }
    radio.now += 16ms;
  }
  CHECK(heard >= 4);
}

TEST_CASE("a team is let go while it runs: its robots are stopped") {
  Radio radio;
  radio.command(commands_of(Team::yellow, {3}));
  Radio::heard(radio.yellow);
  radio.bus.publish(channels::request(), Request{radio.now, 1, "ssl-radio", "param.set", "teams", "blue"});
  radio.now += 100ms;
  radio.command(commands_of(Team::yellow, {3}));
  CHECK(Radio::heard(radio.yellow) == standing(3));

  Queue<Reply> replies(radio.bus, channels::reply(), 10);
  radio.bus.publish(channels::request(), Request{radio.now, 2, "ssl-radio", "param.set", "host", "other"});
  radio.bus.publish(channels::request(), Request{radio.now, 3, "ssl-radio", "param.set", "teams", "green"});
  REQUIRE(radio.run(radio.module, [&] { return replies.reception().received == 2; }));
  CHECK_FALSE(replies.pop()->accepted);
  CHECK_FALSE(replies.pop()->accepted);
}

TEST_CASE("commands that are refused do not keep the robots driving") {
  Radio radio;
  radio.command(commands_of(Team::yellow, {3}));
  Radio::heard(radio.yellow);
  TeamCommands bad = commands_of(Team::yellow, {3});
  bad.commands[0].dribbler_radps = 1e300;  // the bus takes it, the radio does not
  for (int i = 0; i < 12; ++i) {
    radio.now += 10ms;
    radio.command(bad);
  }
  CHECK(radio.module.reception().refused == 12);
  CHECK(Radio::heard(radio.yellow) == standing(3));

  TeamCommands swapped = commands_of(Team::blue, {4});
  radio.bus.publish(channels::commands(Team::yellow), swapped);
  REQUIRE(radio.run(radio.module, [&] { return radio.module.reception().refused == 13; }));
}

TEST_CASE("the simulator's errors come back and are shown") {
  Radio radio;
  radio.command(commands_of(Team::yellow, {3}));
  radio.command(commands_of(Team::blue, {3}));
  CHECK(Radio::heard(radio.blue) != "nothing");
  radio.blue.answer(error_answer());
  REQUIRE(radio.run(radio.module, [&] { return radio.module.reception().received == 1; }));
  CHECK(radio.module.note() == "blue: VELOCITY_TYPE: only local velocity");
  radio.now += 11s;
  CHECK_THAT(radio.module.note(), !Catch::Contains("VELOCITY_TYPE"));
}

TEST_CASE("malformed answers are refused and counted") {
  Radio radio;
  radio.tick();
  REQUIRE(radio.yellow.receive(kPatience_ms));
  const std::string good = error_answer();
  radio.yellow.answer(good.substr(0, good.size() - 3));
  radio.yellow.answer("\xff\xff\xff\xff");
  radio.yellow.answer(protoc_encode("ssl_simulation_response.proto", "RobotControlResponse",
                                    "feedback { dribbler_ball_contact: true }"));
  REQUIRE(radio.run(radio.module, [&] { return radio.module.reception().refused == 3; }));
  CHECK_THAT(radio.module.reception().last_refusal, Catch::Contains("feedback[0].id"));
  radio.yellow.answer(good);
  CHECK(radio.run(radio.module, [&] { return radio.module.reception().received == 1; }));
}

TEST_CASE("nobody at the port is said, and the sending goes on") {
  TestBus here;
  auto yellow = std::make_unique<UdpServer>();
  UdpServer blue;
  SslRadioParams params;
  params.yellow_port = yellow->port();
  params.blue_port = blue.port();
  yellow.reset();
  SslRadioModule module(here.bus, params);
  REQUIRE(here.run(module, [&] { return module.note().starts_with("nobody listens at 127.0.0.1:"); }));
  for (int i = 0; i < 5; ++i) {
    here.now += 400ms;
    module.tick(here.now);
    CHECK_THAT(module.note(), Catch::StartsWith("nobody listens at 127.0.0.1:"));
  }
}

TEST_CASE("the end of the module stops the robots") {
  TestBus here;
  UdpServer yellow;
  UdpServer blue;
  SslRadioParams params;
  params.yellow_port = yellow.port();
  params.blue_port = blue.port();
  {
    SslRadioModule module(here.bus, params);
    here.bus.publish(channels::commands(Team::yellow), commands_of(Team::yellow, {6}));
    REQUIRE(here.run(module, [&] { return Radio::heard(yellow) == driving(6); }));
  }
  CHECK(Radio::heard(yellow) == standing(6));
}

TEST_CASE("a host that cannot be found, or a team that is none, is said in one line") {
  TestBus here;
  SslRadioParams params;
  params.host = "no.such.host.invalid";
  CHECK_THROWS_WITH(SslRadioModule(here.bus, params), Catch::Contains("cannot find the host 'no.such.host.invalid'"));
  params = {};
  params.teams = "green";
  CHECK_THROWS_WITH(SslRadioModule(here.bus, params), Catch::Contains("both, yellow or blue"));
}
