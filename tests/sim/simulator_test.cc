#include "sim/simulator.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "sim/random.h"
#include "sim/validators.h"

namespace regista {
namespace {

constexpr RobotId kYellow{Team::yellow, 3};
constexpr RobotId kBlue{Team::blue, 1};

SimSetup one_robot(const SimParams& params) {
  SimSetup setup;
  setup.params = params;
  setup.robots = {{kYellow, {{-3.0, 1.0}, 0.0}}};
  return setup;
}

TeamCommands tell(RobotId id, const BodyVelocity& velocity, double kick_mps = 0.0) {
  RobotCommand command;
  command.robot = id.number;
  command.velocity = velocity;
  command.kick_speed_mps = kick_mps;
  TeamCommands commands;
  commands.team = id.team;
  commands.commands = {command};
  return commands;
}

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

TEST_CASE("without command a robot stops within the timeout and v/b, in v²/2b") {
  const SimParams params = sim_preset("noisy");
  Simulator simulator(one_robot(params));
  for (int i = 0; i < 150; ++i) {
    simulator.command(tell(kYellow, {3.0, 0.0, 0.5}), simulator.now());
    simulator.advance_to(simulator.now() + Duration{10'000});
  }
  const Time last_arrival = simulator.now() - Duration{10'000};
  const Time silent = last_arrival + from_seconds(params.radio.latency_s + params.radio.timeout_s);
  simulator.advance_to(silent);
  const RobotState moving = simulator.truth().robots[0];
  const double speed = moving.twist.velocity_mps.norm();
  CHECK(speed > 1.0);
  simulator.advance_to(silent + from_seconds(speed / params.limits.braking_max_mps2) + kSimStep);
  const RobotState stopped = simulator.truth().robots[0];
  CHECK(stopped.twist == Twist{});
  CHECK((stopped.pose.position_m - moving.pose.position_m).norm() ==
        Approx(speed * speed / (2.0 * params.limits.braking_max_mps2)).margin(0.005));
}

TEST_CASE("a command moves the robot exactly a latency after it arrived") {
  SimParams params;
  params.radio.latency_s = 0.030;
  Simulator simulator(one_robot(params));
  simulator.advance_to(from_us(5000));
  simulator.command(tell(kYellow, {1.0, 0.0, 0.0}), from_us(5000));
  simulator.advance_to(from_us(35'000));
  CHECK(simulator.truth().robots[0].twist == Twist{});
  simulator.advance_to(from_us(36'000));
  CHECK(simulator.truth().robots[0].twist.velocity_mps.x() == Approx(0.003));
}

TEST_CASE("frames come at the rate, numbered, exactly a latency after they were captured") {
  SimParams params;
  params.vision.latency_s = 0.045;
  SimSetup setup = one_robot(params);
  setup.start = from_us(777);
  Simulator simulator(setup);
  CHECK(simulator.take_frames().empty());
  for (std::uint32_t k = 0; k < 20; ++k) {
    const Time due = simulator.next_frame_due();
    CHECK(due == from_us(777 + 10'000 * k + 45'000));
    simulator.advance_to(due - Duration{1});
    CHECK(simulator.take_frames().empty());
    simulator.advance_to(due);
    const auto frames = simulator.take_frames();
    REQUIRE(frames.size() == 1);
    CHECK(frames[0].frame_number == k);
    CHECK(frames[0].captured == due - Duration{45'000});
    CHECK(frames[0].sent == due);
  }
  simulator.advance_to(simulator.now() + Duration{35'000});
  CHECK(simulator.take_frames().size() == 3);
}

TEST_CASE("a rate that is no multiple of the step: captured at the first step after it is due") {
  SimParams params;
  params.vision.rate_hz = 60.0;
  params.vision.latency_s = 0.0333333;
  Simulator simulator(one_robot(params));
  for (int k = 0; k < 60; ++k) {
    simulator.advance_to(simulator.next_frame_due());
    const auto frames = simulator.take_frames();
    REQUIRE(frames.size() == 1);
    const Duration late = frames[0].captured.time_since_epoch() - from_seconds(k / 60.0);
    CHECK(late >= Duration{0});
    CHECK(late < kSimStep);
    CHECK(frames[0].sent <= simulator.now());
  }
}

TEST_CASE("several cameras take turns, each at the rate, each with its own number and view") {
  SimParams params = sim_preset("realistic");
  params.vision.cameras = 4;
  params.vision.robot_dropout = 0.0;
  SimSetup setup = one_robot(params);  // at (-3, 1): in the upper left quarter
  Simulator simulator(setup);
  std::vector<std::int64_t> frames(4, 0);
  Time last = Time{} - Duration{1};
  for (int k = 0; k < 400; ++k) {
    const Time due = simulator.next_frame_due();
    simulator.advance_to(due);
    for (const VisionFrame& frame : simulator.take_frames()) {
      REQUIRE(frame.camera < 4);
      CHECK(frame.captured > last);
      last = frame.captured;
      CHECK(frame.frame_number == frames[frame.camera]++);
      CHECK(frame.robots.size() == (frame.camera == 2 ? 1 : 0));
    }
  }
  CHECK(frames == std::vector<std::int64_t>(4, 100));
  CHECK(last - Time{} < Duration{1'000'000});
}

TEST_CASE("a robot drives the gain's part of its command") {
  SimParams params;
  params.velocity_gain = 1.05;
  Simulator simulator(one_robot(params));
  for (int i = 0; i < 100; ++i) {
    simulator.command(tell(kYellow, {0.0, 2.0, 0.0}), simulator.now());
    simulator.advance_to(simulator.now() + Duration{10'000});
  }
  CHECK(simulator.truth().robots[0].twist.velocity_mps.norm() == Approx(2.1));
  for (int i = 0; i < 100; ++i) {
    simulator.command(tell(kYellow, {0.0, 0.0, 1.0}), simulator.now());
    simulator.advance_to(simulator.now() + Duration{10'000});
  }
  CHECK(simulator.truth().robots[0].twist.angular_radps == Approx(1.05));
  for (int i = 0; i < 100; ++i) {
    simulator.command(tell(kYellow, {3.0, 0.0, 1.0}), simulator.now());
    simulator.advance_to(simulator.now() + Duration{10'000});
  }
  CHECK(simulator.truth().robots[0].twist.velocity_mps.norm() <= params.limits.speed_max_mps + 1e-9);
}

TEST_CASE("fast robots that would jump through each other in one step touch") {
  SimSetup setup;
  setup.params.limits.speed_max_mps = 20.0;  // 20 mm a step: a chord of 30 mm of both discs is passed in two
  setup.params.limits.acceleration_max_mps2 = 100.0;
  setup.robots = {{kYellow, {{-2.0, 0.0}, 0.0}}, {kBlue, {{2.0, 0.1799}, std::numbers::pi}}};
  setup.ball_m = {0.0, 3.0};
  Simulator simulator(setup);
  for (int i = 0; i < 60; ++i) {
    simulator.command(tell(kYellow, {20.0, 0.0, 0.0}), simulator.now());
    simulator.command(tell(kBlue, {20.0, 0.0, 0.0}), simulator.now());
    simulator.advance_to(simulator.now() + Duration{5'000});
  }
  CHECK(simulator.contact_counts().opponent == 1);
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

TEST_CASE("robots that drive into each other touch, are judged and do not pass through") {
  SimSetup setup;
  setup.robots = {{kBlue, {{1.0, 0.0}, std::numbers::pi}}, {kYellow, {{-1.0, 0.0}, 0.0}}};
  setup.ball_m = {0.0, 3.0};
  Simulator simulator(setup);
  for (int i = 0; i < 200; ++i) {
    simulator.command(tell(kYellow, {3.0, 0.0, 0.0}), simulator.now());
    simulator.command(tell(kBlue, {1.0, 0.0, 0.0}), simulator.now());
    simulator.advance_to(simulator.now() + Duration{10'000});
  }
  CHECK(simulator.contact_counts() == ContactCounts{0, 0, 1, 1, 0});
  REQUIRE(simulator.contacts().size() == 1);
  CHECK(simulator.contacts()[0].fault == Fault::first);
  const WorldState truth = simulator.truth();
  const Vec2 off = find_robot(truth, kBlue)->pose.position_m - find_robot(truth, kYellow)->pose.position_m;
  CHECK(off.x() == Approx(0.18).margin(0.003));
}

TEST_CASE("a kick sends the ball along the heading, as far as it runs") {
  SimParams params;
  Simulator simulator(one_robot(params));
  simulator.teleport(kYellow, {{-4.0, -1.0}, 0.3});
  const Vec2 ahead = rotated({1.0, 0.0}, 0.3);
  const Vec2 ball = Vec2(-4.0, -1.0) + 0.12 * ahead;
  simulator.teleport_ball(ball, {0.0, 0.0});
  simulator.command(tell(kYellow, {}, 2.0), simulator.now());
  simulator.advance_to(simulator.now() + Duration{10'000'000});
  const BallState rested = *simulator.truth().ball;
  CHECK(rested.velocity_mps == Vec2(0.0, 0.0));
  // Slides from v to 0.69 v at 3.9 m/s², then rolls at 0.35 m/s².
  const double run_m = 2.0 * 2.0 * ((1.0 - 0.69 * 0.69) / 7.8 + 0.69 * 0.69 / 0.7);
  CHECK((rested.position_m - ball).norm() == Approx(run_m));
  CHECK(cross(ahead, rested.position_m - ball) == Approx(0.0).margin(1e-9));
}

TEST_CASE("no kick without its command") {
  Simulator simulator(one_robot({}));
  simulator.teleport_ball({-3.0 + 0.12, 1.0}, {0.0, 0.0});
  simulator.command(tell(kYellow, {}), simulator.now());
  simulator.advance_to(simulator.now() + Duration{100'000});
  CHECK(simulator.truth().ball->position_m == Vec2(-3.0 + 0.12, 1.0));
}

TEST_CASE("the boards keep the ball in") {
  Simulator simulator(one_robot({}));
  simulator.teleport_ball({0.0, 0.0}, {3.0, 6.0});
  for (int i = 0; i < 300; ++i) {
    simulator.advance_to(simulator.now() + Duration{10'000});
    const Vec2 position = simulator.truth().ball->position_m;
    REQUIRE(std::abs(position.x()) <= 6.6 - 0.0215);
    REQUIRE(std::abs(position.y()) <= 4.8 - 0.0215);
  }
  CHECK(simulator.truth().ball->velocity_mps.y() < 0.0);
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
