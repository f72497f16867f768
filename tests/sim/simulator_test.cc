// The simulator as a whole: the same bits again, limits and boards kept in the wildest game, time, teleports, refusals.
#include "sim/simulator.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "sim/random.h"
#include "sim/validators.h"
#include "tests/sim/one_robot.h"

namespace regista {
namespace {

using test::kBlue;
using test::kYellow;
using test::one_robot;
using test::tell;

TeamCommands random_commands(Team team, std::uint16_t robots, Random& random) {
  TeamCommands commands;
  commands.team = team;
  for (std::uint16_t number = 0; number < robots; ++number) {
    const double forward = random.uniform(-4.0, 4.0);
    const double left = random.uniform(-4.0, 4.0);
    const double turning = random.uniform(-2.0, 2.0);
    commands.commands.push_back(tell({team, number}, {forward, left, turning}, random.uniform(0.0, 7.0)).commands[0]);
  }
  return commands;
}

struct Run {
  std::vector<VisionFrame> frames;
  std::deque<Contact> contacts;
  WorldState truth;
  std::vector<Violation> violations;
  bool operator==(const Run&) const = default;
};

// Both teams driven at random for ten seconds, many crashes among them.
Run wild_run(std::uint64_t seed, const std::string& preset) {
  Scenario scenario;
  scenario.seed = static_cast<std::int64_t>(seed);
  scenario.sim_preset = preset;
  const SimSetup setup = sim_setup(scenario, from_us(1'000'000));
  Simulator simulator(setup);
  // Random commands ask for more than the limits and lead into the areas; the simulator keeps what it can.
  Validation validation(
      {inside_field(setup.field, setup.params.limits.radius_m), within_speed_limits(setup.params.limits)});
  Random random(99);
  Run run;
  std::vector<TeamCommands> commands;
  for (int tick = 0; tick < 1000; ++tick) {
    if (tick % 50 == 0) commands = {random_commands(Team::yellow, 11, random), random_commands(Team::blue, 11, random)};
    for (const TeamCommands& team : commands) simulator.command(team, simulator.now());
    simulator.advance_to(simulator.now() + Duration{10'000});
    for (VisionFrame& frame : simulator.take_frames()) run.frames.push_back(std::move(frame));
    validation.observe({simulator.truth(), simulator.contact_counts()});
  }
  run.contacts = simulator.contacts();
  run.truth = simulator.truth();
  run.violations = validation.violations();
  return run;
}

TEST_CASE("two runs are equal bit for bit, another seed gives another one") {
  for (const std::string& preset : sim_preset_names()) {
    INFO(preset);
    const Run run = wild_run(1, preset);
    CHECK(run == wild_run(1, preset));
    CHECK(run.frames.size() >= 990);
    CHECK(run.contacts.size() > 5);
    if (preset != "none") CHECK_FALSE(run.frames == wild_run(2, preset).frames);
  }
}

TEST_CASE("limits and boards hold under random commands and crashes") {
  for (const std::string& preset : sim_preset_names()) {
    const Run run = wild_run(1, preset);
    for (const Violation& violation : run.violations) FAIL_CHECK(to_string(violation));
    for (const RobotState& a : run.truth.robots) {
      for (const RobotState& b : run.truth.robots) {
        if (!(a.id < b.id)) continue;
        INFO(to_string(a.id) << " " << to_string(b.id));
        CHECK((a.pose.position_m - b.pose.position_m).norm() > 0.18 - 0.005);
      }
    }
  }
}

TEST_CASE("time goes on in whole steps and never back") {
  Simulator simulator(one_robot({}));
  simulator.advance_to(from_us(2999));
  CHECK(simulator.now() == from_us(2000));
  CHECK(simulator.truth().sequence == 2);
  simulator.advance_to(from_us(2000));
  CHECK(simulator.now() == from_us(2000));
  CHECK_THROWS_WITH(simulator.advance_to(from_us(1999)), Catch::Contains("2000") && Catch::Contains("1999"));
}

TEST_CASE("teleport") {
  Simulator simulator(one_robot({}));
  simulator.teleport(kYellow, {{2.0, -1.0}, 7.0});
  const RobotState robot = simulator.truth().robots[0];
  CHECK(robot.pose.position_m == Vec2(2.0, -1.0));
  CHECK(robot.pose.heading_rad == Approx(7.0 - 2.0 * std::numbers::pi));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(simulator.teleport(kBlue, {}), Catch::Contains("B1"));
  CHECK_THROWS_WITH(simulator.teleport(kYellow, {{6.6, 0.0}, 0.0}), Catch::Contains("6.6"));
  CHECK_THROWS_AS(simulator.teleport(kYellow, {{nan, 0.0}, 0.0}), std::invalid_argument);
  CHECK_THROWS_AS(simulator.teleport(kYellow, {{0.0, 0.0}, nan}), std::invalid_argument);
  CHECK_THROWS_AS(simulator.teleport_ball({0.0, 0.0}, {nan, 0.0}), std::invalid_argument);
  CHECK(simulator.truth().robots[0] == robot);
}

TEST_CASE("a setup that makes no sense is refused") {
  SimSetup setup = one_robot({});
  setup.robots.push_back(setup.robots[0]);
  CHECK_THROWS_WITH(Simulator(setup), Catch::Contains("Y3"));
  setup = one_robot({});
  setup.params.vision.rate_hz = 0.0;
  CHECK_THROWS_WITH(Simulator(setup), Catch::Contains("vision.rate_hz"));
  setup = one_robot({});
  setup.ball_m = {0.0, 5.0};
  CHECK_THROWS_WITH(Simulator(setup), Catch::Contains("ball"));
  Simulator simulator(one_robot({}));
  CHECK_THROWS_WITH(simulator.command(tell(kYellow, {0.0, std::numeric_limits<double>::quiet_NaN(), 0.0}), Time{}),
                    Catch::Contains("nan"));
}

}  // namespace
}  // namespace regista
