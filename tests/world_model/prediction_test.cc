// Predictions against brute-force integration of the same equations.
#include "world_model/prediction.h"

#include <rapidcheck.h>

#include <catch2/catch.hpp>
#include <limits>
#include <stdexcept>

#include "tests/world_model/scene.h"

namespace regista {
namespace {

using test::at_ms;
using test::uniform;

RobotState some_robot(std::mt19937_64& random) {
  RobotState robot;
  robot.id = test::kY3;
  robot.pose = {{uniform(random, -6, 6), uniform(random, -4, 4)}, uniform(random, -3.14, 3.14)};
  robot.twist = {{uniform(random, -3, 3), uniform(random, -3, 3)}, uniform(random, -10, 10)};
  return robot;
}

std::vector<SentVelocity> some_commands(std::mt19937_64& random, int count) {
  std::vector<SentVelocity> sent;
  for (int i = 0; i < count; ++i) {
    sent.push_back({at_ms(10.0 * i), {uniform(random, -3, 3), uniform(random, -3, 3), uniform(random, -10, 10)}});
  }
  return sent;
}

/// Midpoint rule with steps of 10 us; commands change on whole steps.
RobotState integrated(const RobotState& robot, Time from, Time until, const std::vector<SentVelocity>& sent,
                      Duration latency, double lag_s) {
  RobotState out = robot;
  double heading = robot.pose.heading_rad;
  const Duration step{10};
  const double h = to_seconds(step);
  for (Time now = from; now < until; now += step) {
    const SentVelocity* acting = nullptr;
    for (const SentVelocity& command : sent) {
      if (command.captured + latency <= now) acting = &command;
    }
    Twist middle = out.twist;
    Twist change{};
    if (acting != nullptr) {
      const auto slope = [&](const Twist& twist, double at) -> Twist {
        const Twist wanted = to_field(acting->velocity, at);
        return {(wanted.velocity_mps - twist.velocity_mps) / lag_s,
                (wanted.angular_radps - twist.angular_radps) / lag_s};
      };
      const Twist first = slope(out.twist, heading);
      middle.velocity_mps += first.velocity_mps * (h / 2);
      middle.angular_radps += first.angular_radps * (h / 2);
      change = slope(middle, heading + out.twist.angular_radps * h / 2);
    }
    out.pose.position_m += middle.velocity_mps * h;
    heading += middle.angular_radps * h;
    out.twist.velocity_mps += change.velocity_mps * h;
    out.twist.angular_radps += change.angular_radps * h;
  }
  out.pose.heading_rad = wrap_angle(heading);
  return out;
}

TEST_CASE("without commands the robot goes straight on and its heading wraps") {
  RobotState robot;
  robot.pose = {{1.0, 2.0}, 3.0};
  robot.twist = {{1.0, -2.0}, 2.0};
  robot.age = Duration{7};
  const RobotState later = predicted(robot, at_ms(100), at_ms(600), {}, Duration{0}, 0.03);
  CHECK((later.pose.position_m - Vec2(1.5, 1.0)).norm() < 1e-12);
  CHECK(later.pose.heading_rad == Approx(4.0 - 2.0 * std::numbers::pi));
  CHECK(later.twist == robot.twist);
  CHECK(later.age == robot.age);
}

TEST_CASE("commanded prediction equals brute-force integration") {
  std::mt19937_64 random(3);
  for (int run = 0; run < 30; ++run) {
    CAPTURE(run);
    const RobotState robot = some_robot(random);
    const std::vector<SentVelocity> sent = some_commands(random, 8);
    const Duration latency{static_cast<std::int64_t>(random() % 6000) * 10};
    const double lag_s = uniform(random, 0.01, 0.1);
    const RobotState exact = predicted(robot, at_ms(20), at_ms(120), sent, latency, lag_s);
    const RobotState brute = integrated(robot, at_ms(20), at_ms(120), sent, latency, lag_s);
    CHECK((exact.pose.position_m - brute.pose.position_m).norm() < 2e-5);
    CHECK(std::abs(wrap_angle(exact.pose.heading_rad - brute.pose.heading_rad)) < 1e-6);
    CHECK((exact.twist.velocity_mps - brute.twist.velocity_mps).norm() < 5e-4);
    CHECK(exact.twist.angular_radps == Approx(brute.twist.angular_radps).margin(1e-4));
  }
}

TEST_CASE("without lag the robot has the commanded velocity and drives an arc") {
  std::mt19937_64 random(4);
  for (int run = 0; run < 50; ++run) {
    const RobotState robot = some_robot(random);
    const double rate = run == 0 ? 0.0 : uniform(random, -10, 10);
    const std::vector<SentVelocity> sent{{at_ms(0), {2.0, 0.0, rate}}};
    const RobotState out = predicted(robot, at_ms(0), at_ms(100), sent, Duration{0}, 0.0);
    const double turned = rate * 0.1;
    CHECK(std::abs(wrap_angle(out.pose.heading_rad - robot.pose.heading_rad - turned)) < 1e-12);
    CHECK((out.twist.velocity_mps - rotated({2.0, 0.0}, out.pose.heading_rad)).norm() < 1e-12);
    const double chord = rate == 0.0 ? 0.2 : std::abs(2.0 * (2.0 / rate) * std::sin(turned / 2.0));
    CHECK((out.pose.position_m - robot.pose.position_m).norm() == Approx(chord).margin(1e-12));
  }
}

TEST_CASE("a vanishing lag leads to no lag") {
  std::mt19937_64 random(5);
  const RobotState robot = some_robot(random);
  const std::vector<SentVelocity> sent = some_commands(random, 5);
  const RobotState none = predicted(robot, at_ms(0), at_ms(45), sent, Duration{0}, 0.0);
  const RobotState tiny = predicted(robot, at_ms(0), at_ms(45), sent, Duration{0}, 1e-6);
  CHECK((none.pose.position_m - tiny.pose.position_m).norm() < 1e-4);
  CHECK((none.twist.velocity_mps - tiny.twist.velocity_mps).norm() < 1e-3);
}

TEST_CASE("a command acts only after its latency and only until the next") {
  const RobotState still{};
  const std::vector<SentVelocity> sent{{at_ms(0), {1.0, 0.0, 0.0}}, {at_ms(10), {0.0, 1.0, 0.0}}};
  const auto at = [&](double ms) { return predicted(still, at_ms(0), at_ms(ms), sent, at_ms(30) - at_ms(0), 0.0); };
  CHECK(at(30).twist.velocity_mps == Vec2(0.0, 0.0));  // made, but acting only from now on
  CHECK((at(40).pose.position_m - Vec2(0.01, 0.0)).norm() < 1e-12);
  CHECK((at(60).pose.position_m - Vec2(0.01, 0.02)).norm() < 1e-12);
  CHECK((at(60).twist.velocity_mps - Vec2(0.0, 1.0)).norm() < 1e-12);
}

TEST_CASE("prediction in two parts equals prediction at once") {
  REQUIRE(rc::check([] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    const RobotState robot = some_robot(random);
    const std::vector<SentVelocity> sent = some_commands(random, 6);
    const double lag_s = random() % 2 == 0 ? 0.0 : uniform(random, 0.005, 0.1);
    const Time middle = at_ms(uniform(random, 0, 100));
    const RobotState once = predicted(robot, at_ms(0), at_ms(100), sent, at_ms(20) - at_ms(0), lag_s);
    const RobotState half = predicted(robot, at_ms(0), middle, sent, at_ms(20) - at_ms(0), lag_s);
    const RobotState twice = predicted(half, middle, at_ms(100), sent, at_ms(20) - at_ms(0), lag_s);
    RC_ASSERT((once.pose.position_m - twice.pose.position_m).norm() < 5e-5);
    RC_ASSERT((once.twist.velocity_mps - twice.twist.velocity_mps).norm() < 1e-3);
    RC_ASSERT(std::abs(wrap_angle(once.pose.heading_rad - twice.pose.heading_rad)) < 1e-9);
  }));
}

TEST_CASE("broken preconditions throw") {
  const std::vector<SentVelocity> unsorted{{at_ms(10), {}}, {at_ms(0), {}}};
  CHECK_THROWS_AS(predicted(RobotState{}, at_ms(1), at_ms(0), {}, Duration{0}, 0.0), std::invalid_argument);
  CHECK_THROWS_AS(predicted(RobotState{}, at_ms(0), at_ms(1), unsorted, Duration{0}, 0.0), std::invalid_argument);
  CHECK_THROWS_AS(predicted(RobotState{}, at_ms(0), at_ms(1), {}, Duration{0}, -0.1), std::invalid_argument);
  CHECK_THROWS_AS(
      predicted(RobotState{}, at_ms(0), at_ms(1), {}, Duration{0}, std::numeric_limits<double>::quiet_NaN()),
      std::invalid_argument);
  CHECK_THROWS_AS(predicted(BallState{}, Duration{-1}, 0.3), std::invalid_argument);
  CHECK_THROWS_AS(predicted(BallState{}, Duration{1}, -0.3), std::invalid_argument);
}

TEST_CASE("a ball rolls to rest and never back") {
  BallState ball;
  ball.velocity_mps = {0.6, 0.8};
  const double stop_s = 1.0 / 0.35;
  double travelled = 0.0;
  for (int ms = 0; ms <= 6000; ms += 100) {
    const BallState later = predicted(ball, Duration{ms * 1000}, 0.35);
    const double distance = later.position_m.norm();
    CHECK(distance >= travelled);
    CHECK(later.velocity_mps.dot(ball.velocity_mps) >= 0.0);
    CHECK(std::abs(cross(later.position_m, ball.velocity_mps)) < 1e-12);
    if (ms / 1000.0 > stop_s) {
      CHECK(later.velocity_mps == Vec2(0.0, 0.0));
      CHECK(distance == Approx(1.0 / 0.7));
    }
    travelled = distance;
  }
}

}  // namespace
}  // namespace regista
