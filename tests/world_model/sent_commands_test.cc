// What the world model makes of the commands that robots were sent: it predicts with them, and knows them as long as
// they matter.
#include <catch2/catch.hpp>

#include "tests/world_model/scene.h"
#include "world_model/prediction.h"
#include "world_model/world_model.h"

namespace regista {
namespace {

using test::at_ms;
using test::feed;
using test::frame;
using test::kB0;
using test::kY3;

TEST_CASE("the state is predicted by the latency with the commands that will act") {
  WorldModelParams params;
  params.latency_s = 0.06;
  params.velocity_lag_s = 0.03;
  params.robot.position_sigma_m = 1e-6;
  WorldModel world(params);
  RobotState truth;
  truth.id = kY3;
  std::vector<SentVelocity> sent;
  std::vector<RobotState> history;
  WorldState state;
  for (int i = 0; i < 200; ++i) {
    history.push_back(truth);
    world.add_frame(frame(at_ms(10.0 * i), static_cast<std::uint32_t>(i), {{kY3, truth.pose, 1.0}}));
    if (i >= 106) {  // the state made 60 ms earlier foretold this moment
      REQUIRE(state.valid_at >= at_ms(10.0 * i));
    }
    state = world.state();
    sent.push_back({at_ms(10.0 * i), {std::sin(0.05 * i), 0.5, 2.0 * std::cos(0.03 * i)}});
    REQUIRE(world.add_command(kY3, sent.back()));
    truth = predicted(truth, at_ms(10.0 * i), at_ms(10.0 * (i + 1)), sent, from_seconds(0.06), 0.03);
  }
  const RobotState later = predicted(history.back(), at_ms(1990), at_ms(2050), sent, from_seconds(0.06), 0.03);
  REQUIRE(state.robots.size() == 1);
  CHECK(state.captured == at_ms(1990));
  CHECK(state.valid_at == at_ms(2050));
  CHECK((state.robots[0].pose.position_m - later.pose.position_m).norm() < 1e-4);
  CHECK((state.robots[0].twist.velocity_mps - later.twist.velocity_mps).norm() < 2e-3);
  CHECK(std::abs(wrap_angle(state.robots[0].pose.heading_rad - later.pose.heading_rad)) < 1e-3);
}

TEST_CASE("a robot out of sight moves on as it was told") {
  WorldModel world;
  RobotState truth;
  std::vector<SentVelocity> sent;
  WorldState state;
  for (int i = 0; i < 115; ++i) {
    std::vector<RobotDetection> seen;
    if (i <= 100) seen.push_back({kY3, truth.pose, 1.0});  // then hidden for 140 ms while it speeds up
    world.add_frame(frame(at_ms(10.0 * i), static_cast<std::uint32_t>(i), seen));
    state = world.state();
    if (i == 114) break;
    sent.push_back({at_ms(10.0 * i), {i < 100 ? 1.0 : 1.0 + 0.03 * (i - 100), 0.0, 0.0}});
    REQUIRE(world.add_command(kY3, sent.back()));
    truth = predicted(truth, at_ms(10.0 * i), at_ms(10.0 * (i + 1)), sent, Duration{0}, 0.0);
  }
  REQUIRE(state.robots.size() == 1);
  CHECK(state.robots[0].age == Duration{140000});
  CHECK((state.robots[0].pose.position_m - truth.pose.position_m).norm() < 1e-3);
  CHECK((state.robots[0].twist.velocity_mps - truth.twist.velocity_mps).norm() < 1e-3);
}

TEST_CASE("commands from before a restart of the clock are forgotten, as are those that stopped coming") {
  WorldModel world;
  feed(world, kY3, {}, {}, 60000, 60100);
  REQUIRE(world.add_command(kY3, {at_ms(60100), {2.0, 0.0, 0.0}}));
  feed(world, kY3, {}, {}, 0, 100);
  WorldModelParams ahead = world.params();
  ahead.latency_s = 0.1;
  world.set_params(ahead);
  REQUIRE(world.add_command(kY3, {at_ms(0), {1.0, 0.0, 0.0}}));
  feed(world, kY3, {}, {}, 110, 190);
  CHECK((world.state().robots.at(0).twist.velocity_mps - Vec2(1.0, 0.0)).norm() < 1e-6);
  feed(world, kY3, {}, {}, 200, 500);
  CHECK(world.state().robots.at(0).twist.velocity_mps.norm() < 1e-3);
}

TEST_CASE("commands are kept for robots in sight only, and go with them") {
  WorldModelParams params;
  params.latency_s = 0.05;
  WorldModel world(params);
  feed(world, kY3, {}, {}, 0, 100);
  CHECK_FALSE(world.add_command(kB0, {at_ms(100), {1.0, 0.0, 0.0}}));
  CHECK(world.add_command(kY3, {at_ms(100), {1.0, 0.0, 0.0}}));
  feed(world, kB0, {}, {}, 110, 700);  // Y3 is gone
  CHECK_FALSE(world.add_command(kY3, {at_ms(700), {1.0, 0.0, 0.0}}));
}

TEST_CASE("a robot hidden for long under the longest latency still knows all its commands") {
  WorldModelParams params;
  params.latency_s = 1.0;
  params.robot_lost_after_s = 5.0;
  WorldModel world(params);
  RobotState truth;
  std::vector<SentVelocity> sent;
  for (int i = 0; i <= 500; ++i) {
    std::vector<RobotDetection> seen;
    if (i <= 50) seen.push_back({kY3, {}, 1.0});  // stands, then is hidden for 4.5 s and drives to and fro
    world.add_frame(frame(at_ms(10.0 * i), static_cast<std::uint32_t>(i), seen));
    sent.push_back({at_ms(10.0 * i), {i / 100 % 2 == 0 ? 0.0 : 1.0, 0.0, 0.0}});
    world.add_command(kY3, sent.back());
  }
  truth = predicted(truth, at_ms(500), at_ms(6000), sent, from_seconds(1.0), 0.0);
  const WorldState state = world.state();
  REQUIRE(state.robots.size() == 1);
  CHECK((state.robots[0].pose.position_m - truth.pose.position_m).norm() < 1e-6);
}

}  // namespace
}  // namespace regista
