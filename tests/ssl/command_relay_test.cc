#include "modules/ssl/command_relay.h"

#include <catch2/catch.hpp>
#include <random>

using namespace regista;
using namespace std::chrono_literals;

namespace {

std::vector<RobotCommand> driving(const std::vector<std::uint16_t>& robots) {
  std::vector<RobotCommand> out;
  for (const std::uint16_t robot : robots) {
    RobotCommand command;
    command.robot = robot;
    command.velocity.forward_mps = 1.0;
    out.push_back(command);
  }
  return out;
}

std::vector<RobotCommand> stops(const std::vector<std::uint16_t>& robots) {
  std::vector<RobotCommand> out = driving(robots);
  for (RobotCommand& command : out) command.velocity = {};
  return out;
}

constexpr Time kStart = from_us(5'000'000);

}  // namespace

TEST_CASE("a port is never quiet: the first datagram at once, then twice a second and more") {
  CommandRelay relay(kStart);
  CHECK(relay.due() <= kStart);
  CHECK(relay.idle(kStart).empty());
  CHECK(relay.due() > kStart);
  CHECK(relay.due() <= kStart + 500ms);
}

TEST_CASE("silence stops the robots after 100 ms, again and again for 2 s") {
  CommandRelay relay(kStart);
  CHECK(relay.beside(driving({1, 4}), kStart).empty());
  Time now = kStart;
  for (int i = 1; i <= 20; ++i) {
    now = relay.due();
    REQUIRE(now == kStart + i * 100ms);
    REQUIRE(relay.idle(now) == stops({1, 4}));
  }
  now = relay.due();
  CHECK(relay.idle(now).empty());
  CHECK(relay.due() == now + CommandRelay::kKeepAlive);
}

TEST_CASE("a robot that loses its command is stopped while the others drive on") {
  CommandRelay relay(kStart);
  relay.beside(driving({1, 4}), kStart);
  CHECK(relay.beside(driving({4}), kStart + 10ms) == stops({1}));
  CHECK(relay.beside(driving({4}), kStart + 1990ms) == stops({1}));
  CHECK(relay.beside(driving({4}), kStart + 2010ms).empty());
  CHECK(relay.beside(driving({1}), kStart + 2020ms) == stops({4}));
}

TEST_CASE("whatever comes, due lies after what was sent, and nobody driven lately is forgotten") {
  const std::uint64_t seed = 20250611;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  CommandRelay relay(kStart);
  std::map<std::uint16_t, Time> driven;
  Time now = kStart;
  for (int i = 0; i < 10'000; ++i) {
    now += Duration{static_cast<std::int64_t>(random() % 300'000)};
    std::vector<std::uint16_t> robots;
    for (std::uint16_t robot = 0; robot < 5; ++robot) {
      if (random() % 3 == 0) robots.push_back(robot);
    }
    const bool fresh = random() % 2 == 0;
    std::vector<std::uint16_t> wanted;
    for (const auto& [robot, at] : driven) {
      const bool commanded = fresh && std::find(robots.begin(), robots.end(), robot) != robots.end();
      if (now - at <= CommandRelay::kStopFor && !commanded) wanted.push_back(robot);
    }
    REQUIRE((fresh ? relay.beside(driving(robots), now) : relay.idle(now)) == stops(wanted));
    if (fresh) {
      for (const std::uint16_t robot : robots) driven[robot] = now;
    }
    REQUIRE(relay.due() > now);
    REQUIRE(relay.due() - now <= CommandRelay::kKeepAlive);
  }
}
