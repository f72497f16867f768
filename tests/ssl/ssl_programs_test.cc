// The two programs as processes: SSL packets over real multicast and UDP on one side, LCM over real multicast on the
// other.
#include <catch2/catch.hpp>
#include <csignal>
#include <set>

#include "modules/bus/mailbox.h"
#include "modules/convert/commands.h"
#include "modules/convert/service.h"
#include "modules/convert/vision.h"
#include "modules/process/real_clock.h"
#include "tests/ssl/packets.h"
#include "tests/ssl/plain_udp.h"
#include "tests/ssl/protoc.h"
#include "tests/support/program.h"

using namespace regista;
using namespace std::chrono_literals;

namespace {

/// Repeats the action and takes messages until the condition holds.
bool eventually(Bus& bus, const std::function<void()>& action, const std::function<bool()>& condition) {
  return regista::eventually([&] {
    action();
    while (bus.handle(0ms)) {
    }
    return condition();
  });
}

}  // namespace

TEST_CASE("regista-ssl-vision: cameras, geometry and malformed packets, from group to bus") {
  const std::string url = private_bus();
  Bus bus(url, real_clock());
  Queue<VisionFrame> frames(bus, channels::vision(), 10'000);
  Mailbox<FieldAnnouncement> field(bus, channels::geometry());
  Mailbox<ModuleStatus> status(bus, channels::status("ssl-vision"));
  Program program({executable("regista-ssl-vision"), "--lcm-url", url, "--set", "ssl_vision.group=" + private_group(),
                   "--set", "ssl_vision.port=" + std::to_string(private_port()), "--set", "ssl_vision.interface=lo"});
  MulticastSender source(private_group(), private_port());
  const std::string camera_0 = encode_vision(detection_text(0, 1) + geometry_text());
  const std::string camera_1 = encode_vision(detection_text(1, 2));
  std::set<std::uint32_t> cameras;
  REQUIRE(eventually(
      bus,
      [&] {
        source.send(camera_0);
        source.send(camera_1);
        while (const auto frame = frames.pop()) cameras.insert(frame->camera);
      },
      [&] { return cameras.size() == 2 && field.newest() != nullptr; }));
  CHECK(field.newest()->field == division_a());

  source.send(camera_0.substr(0, 40));
  source.send("");
  source.send(std::string(1000, '\xff'));
  source.send(encode_vision("detection { frame_number: 1 camera_id: 0 t_capture: nan t_sent: 1 }"));
  source.send(encode_vision("detection { frame_number: 1 camera_id: 0 t_capture: 1 }"));
  CHECK(eventually(
      bus, [] {}, [&] { return status.newest() != nullptr && status.newest()->refused == 5; }));

  const std::string later = encode_vision(detection_text(4, 77));
  std::optional<VisionFrame> frame;
  CHECK(eventually(
      bus, [&] { source.send(later); },
      [&] {
        while (auto next = frames.pop()) {
          if (next->camera == 4) frame = next;
        }
        return frame.has_value();
      }));
  CHECK(is_alive(program.pid()));
  program.send(SIGINT);
  CHECK(program.wait() == 0);
  CHECK_THAT(program.error(), !Catch::Contains("libprotobuf"));
}

TEST_CASE("regista-ssl-radio: from bus to port, and a stop at the end") {
  const std::string url = private_bus();
  Bus bus(url, real_clock());
  Mailbox<ModuleStatus> status(bus, channels::status("ssl-radio"));
  UdpServer yellow;
  UdpServer blue;
  Program program({executable("regista-ssl-radio"), "--lcm-url", url, "--set",
                   "ssl_radio.yellow_port=" + std::to_string(yellow.port()), "--set",
                   "ssl_radio.blue_port=" + std::to_string(blue.port())});
  TeamCommands commands;
  commands.team = Team::blue;
  regista::RobotCommand command;
  command.robot = 9;
  command.velocity = {1.0, 2.0, -0.5};
  commands.commands = {command};
  const auto decoded = [](const std::string& bytes) {
    return protoc_decode("ssl_simulation_control.proto", "RobotControl", bytes);
  };
  std::string heard;
  REQUIRE(eventually(
      bus, [&] { bus.publish(channels::commands(Team::blue), commands); },
      [&] {
        while (const auto bytes = blue.receive(0)) heard = decoded(*bytes);
        return heard.find("left: 2\n") != std::string::npos;
      }));
  CHECK_THAT(heard,
             Catch::Contains("id: 9\n") && Catch::Contains("forward: 1\n") && Catch::Contains("angular: -0.5\n"));
  CHECK(yellow.receive(5000));

  blue.answer(
      protoc_encode("ssl_simulation_response.proto", "RobotControlResponse", R"(errors { code: "TEST_ERROR" })"));
  CHECK(eventually(
      bus, [&] { bus.publish(channels::commands(Team::blue), commands); },
      [&] { return status.newest() != nullptr && status.newest()->note == "blue: TEST_ERROR"; }));
  CHECK_THAT(program.out(), Catch::Contains("TEST_ERROR"));

  program.send(SIGINT);
  CHECK(program.wait() == 0);
  while (const auto bytes = blue.receive(0)) heard = decoded(*bytes);
  CHECK_THAT(heard, Catch::Contains("id: 9\n") && Catch::Contains("left: 0\n"));
}

TEST_CASE("what cannot work ends with status 1 and one line") {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"regista-ssl-radio", "ssl_radio.host=no.such.host.invalid"},
      {"regista-ssl-radio", "ssl_radio.teams=green"},
      {"regista-ssl-radio", "ssl_radio.tems=blue"},
      {"regista-ssl-vision", "ssl_vision.interface=no-such-card"},
      {"regista-ssl-vision", "ssl_vision.group=127.0.0.1"},
      {"regista-ssl-vision", "ssl_vision.port=0"},
      {"regista-ssl-referee", "ssl_referee.group=10.0.0.1"},
      {"regista-ssl-referee", "ssl_referee.prt=10003"},
  };
  for (const auto& [name, setting] : cases) {
    CAPTURE(name, setting);
    const RunResult result = run({executable(name), "--lcm-url", "memq://", "--set", setting});
    CHECK(result.status == 1);
    CHECK(result.out.empty());
    CHECK_THAT(result.error, Catch::StartsWith(name + ": "));
    CHECK(std::count(result.error.begin(), result.error.end(), '\n') == 1);
  }
}
