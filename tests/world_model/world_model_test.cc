// The world model as a whole: who is reported, since when, how long, and what is not believed.
#include "world_model/world_model.h"

#include <catch2/catch.hpp>

#include "tests/world_model/scene.h"

namespace regista {
namespace {

using test::at_ms;
using test::feed;
using test::frame;
using test::kB0;
using test::kY3;

TEST_CASE("before the first frame the world is empty, and states count up") {
  WorldModel world;
  CHECK(world.state().sequence == 1);
  const WorldState second = world.state();
  CHECK(second.sequence == 2);
  CHECK(second.robots.empty());
  CHECK_FALSE(second.ball);
  CHECK_FALSE(world.add_command(kY3, {}));
}

TEST_CASE("robots appear when believed, sorted, age, and go") {
  WorldModelParams params;
  params.robot_lost_after_s = 0.5;
  WorldModel world(params);
  world.add_frame(frame(at_ms(0), 0, {{kB0, {}, 1.0}, {kY3, {{1.0, 0.0}, 0.0}, 1.0}}));
  CHECK(world.state().robots.empty());
  world.add_frame(frame(at_ms(10), 1, {{kB0, {}, 1.0}, {kY3, {{1.0, 0.0}, 0.0}, 1.0}}));
  const WorldState both = world.state();
  REQUIRE(both.robots.size() == 2);
  CHECK(both.robots[0].id == kY3);
  CHECK(both.robots[1].id == kB0);
  for (int ms = 20; ms <= 510; ms += 10) {
    world.add_frame(frame(at_ms(ms), static_cast<std::uint32_t>(ms), {{kY3, {{1.0, 0.0}, 0.0}, 1.0}}));
    const WorldState state = world.state();
    REQUIRE(find_robot(state, kB0) != nullptr);
    REQUIRE(find_robot(state, kB0)->age == at_ms(ms) - at_ms(10));
    REQUIRE(find_robot(state, kY3)->age == Duration{0});
  }
  world.add_frame(frame(at_ms(520), 520, {{kY3, {{1.0, 0.0}, 0.0}, 1.0}}));
  CHECK(find_robot(world.state(), kB0) == nullptr);
  CHECK(find_robot(world.state(), kY3) != nullptr);
}

TEST_CASE("a lost robot coasts on and becomes less certain; the ball goes after its own time") {
  WorldModel world;
  for (int ms = 0; ms <= 1000; ms += 10) {
    world.add_frame(
        frame(at_ms(ms), static_cast<std::uint32_t>(ms), {{kY3, {{0.002 * ms, 0.0}, 0.0}, 1.0}}, {{{1.0, 1.0}, 1.0}}));
  }
  const WorldState seen = world.state();
  REQUIRE(seen.ball);
  const auto see_nothing = [&](int first_ms, int last_ms) {
    for (int ms = first_ms; ms <= last_ms; ms += 10)
      world.add_frame(frame(at_ms(ms), static_cast<std::uint32_t>(ms), {}));
  };
  see_nothing(1010, 1200);
  const WorldState coasting = world.state();
  REQUIRE(coasting.robots.size() == 1);
  CHECK(coasting.robots[0].pose.position_m.x() == Approx(2.4).margin(1e-4));
  CHECK(coasting.robots[0].position_variance_m2 > seen.robots[0].position_variance_m2);
  CHECK(coasting.ball->age == Duration{200000});
  see_nothing(1210, 1990);
  CHECK(world.state().robots.empty());
  CHECK(world.state().ball);
  see_nothing(2000, 2010);
  CHECK_FALSE(world.state().ball);
}

TEST_CASE("a false detection is ignored, a teleport believed") {
  WorldModel world;
  feed(world, kY3, {}, {}, 0, 500);
  const auto position = [&] { return world.state().robots.at(0).pose.position_m; };
  world.add_frame(frame(at_ms(510), 51, {{kY3, {{2.0, 0.0}, 0.0}, 1.0}}));
  CHECK(position().norm() < 1e-6);
  world.add_frame(frame(at_ms(520), 52, {{kY3, {}, 1.0}, {kY3, {{2.0, 0.0}, 0.0}, 1.0}}));  // two of one id
  CHECK(position().norm() < 1e-6);
  for (int ms = 530; ms <= 540; ms += 10) {
    world.add_frame(frame(at_ms(ms), static_cast<std::uint32_t>(ms), {{kY3, {{2.0, 0.0}, 1.0}, 1.0}}));
    CHECK(position().norm() < 1e-6);
  }
  world.add_frame(frame(at_ms(550), 55, {{kY3, {{2.0, 0.0}, 1.0}, 1.0}}));
  CHECK((position() - Vec2(2.0, 0.0)).norm() < 1e-6);
  CHECK(world.state().robots[0].twist.velocity_mps.norm() < 1e-6);
  CHECK(world.state().robots[0].pose.heading_rad == Approx(1.0));
}

TEST_CASE("false detections that jump about never take the robot along") {
  std::mt19937_64 random(11);
  WorldModel world;
  feed(world, kY3, {}, {}, 0, 100);
  for (int ms = 110; ms < 400; ms += 10) {
    const Vec2 far = rotated({test::uniform(random, 1.0, 5.0), 0.0}, ms);
    world.add_frame(frame(at_ms(ms), static_cast<std::uint32_t>(ms), {{kY3, {far, 0.0}, 1.0}}));
    REQUIRE(world.state().robots.at(0).pose.position_m.norm() < 1e-6);
  }
}

TEST_CASE("false detections that return twice a second are never believed") {
  WorldModel world;
  for (int ms = 0; ms <= 5000; ms += 10) {
    const bool ghost = ms % 500 == 0;
    world.add_frame(frame(at_ms(ms), static_cast<std::uint32_t>(ms),
                          ghost ? std::vector<RobotDetection>{{kB0, {}, 1.0}} : std::vector<RobotDetection>{},
                          ghost ? std::vector<BallDetection>{{{1.0, 1.0}, 1.0}} : std::vector<BallDetection>{}));
    const WorldState state = world.state();
    REQUIRE(state.robots.empty());
    REQUIRE_FALSE(state.ball);
  }
}

TEST_CASE("by default vision is as noisy as the league's") {
  CHECK(RobotFilterParams{}.position_sigma_m == 0.0013);
  CHECK(RobotFilterParams{}.heading_sigma_rad == 0.010);
}

TEST_CASE("parameters list, set and refuse") {
  WorldModelParams params;
  set_param(params, "robot.position_sigma_m", "0.0013");
  CHECK(params.robot.position_sigma_m == 0.0013);
  set_param(params, "frames.late_s", "0.02");
  CHECK(params.frames.late_s == 0.02);
  CHECK_THROWS_AS(set_param(params, "latency_s", "-1"), ParamError);
  CHECK_THROWS_AS(set_param(params, "latencys", "0"), ParamError);
  for (const ParamInfo& info : list_params(params)) CHECK_NOTHROW(set_param(params, info.key, info.value));
}

}  // namespace
}  // namespace regista
