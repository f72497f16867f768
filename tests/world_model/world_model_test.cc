// The world model as a whole: who is reported, since when, how long, and what bad input does.
#include "world_model/world_model.h"

#include <catch2/catch.hpp>
#include <limits>
#include <stdexcept>

#include "tests/world_model/scene.h"
#include "world_model/prediction.h"
#include "world_model/types/plausible.h"

namespace regista {
namespace {

using test::at_ms;
using test::frame;
using test::kB0;
using test::kY3;

/// Frames every 10 ms from first_ms to last_ms with one robot in constant motion.
void feed(WorldModel& world, RobotId id, const Pose& start, const Twist& twist, int first_ms, int last_ms) {
  for (int ms = first_ms; ms <= last_ms; ms += 10) {
    world.add_frame(
        frame(at_ms(ms), static_cast<std::uint32_t>(ms / 10), {{id, test::moved(start, twist, 0.001 * ms), 1.0}}));
  }
}

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

TEST_CASE("shuffled, repeated and late frames never move time backwards") {
  std::mt19937_64 random(10);
  WorldModel world;
  WorldState last = world.state();
  for (int i = 0; i < 3000; ++i) {
    const int ms = 1000 + 10 * i - 10 * static_cast<int>(random() % 12);
    const Pose pose = test::moved({}, {{1.0, 0.5}, 1.0}, 0.001 * ms);
    const FrameResult result =
        world.add_frame(frame(at_ms(ms), static_cast<std::uint32_t>(ms + 1000), {{kY3, pose, 1.0}}));
    const WorldState now = world.state();
    REQUIRE(now.captured >= last.captured);
    REQUIRE(now.valid_at >= last.valid_at);
    if (result != FrameResult::taken) {
      last.sequence = now.sequence;
      REQUIRE(now == last);
    }
    if (i > 300) {
      const Pose truth = test::moved({}, {{1.0, 0.5}, 1.0}, to_seconds(now.valid_at.time_since_epoch()));
      REQUIRE(now.robots.size() == 1);
      REQUIRE((now.robots[0].pose.position_m - truth.position_m).norm() < 1e-6);
    }
    last = now;
  }
}

TEST_CASE("two cameras that see one robot at different times agree with one") {
  const Twist twist{{2.0, -1.0}, 4.0};
  const Pose start{{-3.0, 1.0}, 2.0};
  WorldModel world;
  for (int i = 0; i < 200; ++i) {
    const auto number = static_cast<std::uint32_t>(i);
    const auto see = [&](double ms, std::uint32_t camera) {
      return world.add_frame(frame(at_ms(ms), number, {{kY3, test::moved(start, twist, 0.001 * ms), 1.0}}, {}, camera));
    };
    REQUIRE(see(10.0 * i, 0) == FrameResult::taken);
    REQUIRE(see(10.0 * i - 4.0, 1) == FrameResult::taken);  // its frames come behind
  }
  const WorldState state = world.state();
  REQUIRE(state.robots.size() == 1);
  const Pose truth = test::moved(start, twist, 1.99);
  CHECK(state.captured == at_ms(1990));
  // The cameras were compared before the velocity was known exactly, which leaves a shift of nanometres.
  CHECK((state.robots[0].pose.position_m - truth.position_m).norm() < 1e-7);
  CHECK((state.robots[0].twist.velocity_mps - twist.velocity_mps).norm() < 1e-6);
  CHECK(std::abs(wrap_angle(state.robots[0].pose.heading_rad - truth.heading_rad)) < 1e-8);
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

TEST_CASE("a simulator that starts again is followed, with nothing left from before") {
  WorldModel world;
  feed(world, kY3, {}, {}, 60000, 61000);
  feed(world, kB0, {}, {}, 0, 100);
  const WorldState state = world.state();
  CHECK(state.captured == at_ms(100));
  REQUIRE(state.robots.size() == 1);
  CHECK(state.robots[0].id == kB0);
}

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

TEST_CASE("a frame that comes behind does not make a robot older") {
  WorldModel world;
  feed(world, kY3, {}, {}, 0, 100);
  REQUIRE(world.add_frame(frame(at_ms(70), 1, {{kY3, {}, 1.0}}, {}, 1)) == FrameResult::taken);
  CHECK(world.state().robots.at(0).age == Duration{0});
}

TEST_CASE("stray stamps ahead cost neither robots nor more than a few frames") {
  for (const int stray_ms : {100, 300, 600, 1000, 3000, 4900}) {
    CAPTURE(stray_ms);
    WorldModel world;
    std::uint32_t number = 0;
    for (int ms = 0; ms <= 6000; ms += 10) {
      if (ms > 0 && ms % 1000 == 0) world.add_frame(frame(at_ms(ms - 10 + stray_ms), number++, {{kB0, {}, 1.0}}));
      world.add_frame(frame(at_ms(ms), number++, {{kY3, {}, 1.0}}));
      const WorldState state = world.state();
      if (ms > 100) REQUIRE(find_robot(state, kY3) != nullptr);
      REQUIRE(state.captured - at_ms(ms) <= at_ms(100) - at_ms(0));
    }
    const FrameCounts& counts = world.frame_counts();
    CHECK(counts.restarted == 0);
    CHECK(counts.late <= 6 * 4);
    CHECK(counts.refused <= 6);
    CHECK(counts.taken + counts.late + counts.refused == 601 + 6);
  }
}

TEST_CASE("frames are counted by result: a camera that is always behind shows") {
  WorldModel world;
  for (int i = 0; i < 100; ++i) {
    const auto number = static_cast<std::uint32_t>(i);
    world.add_frame(frame(at_ms(1000 + 10.0 * i), number, {}));
    if (i > 0) world.add_frame(frame(at_ms(940 + 10.0 * i), number, {}, {}, 1));
    if (i == 0) world.add_frame(frame(at_ms(1000), number, {}));
  }
  CHECK(world.frame_counts() == FrameCounts{100, 0, 1, 99, 0});
  for (std::uint32_t i = 0; i < 3; ++i) world.add_frame(frame(at_ms(90000 + 10.0 * i), i, {}));
  CHECK(world.frame_counts() == FrameCounts{100, 1, 1, 99, 2});
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

TEST_CASE("whatever is plausible is taken") {
  for (const double sign : {-1.0, 1.0}) {
    WorldModel world;
    const Time last = from_us(kLatestStamp_us);
    const Vec2 corner(sign * kFarthest_m, -sign * kFarthest_m);
    CHECK_NOTHROW(world.add_frame(frame(from_us(-kLatestStamp_us), 1, {{kY3, {corner, 0.0}, 1.0}}, {{corner, 1.0}})));
    for (int i = 3; i >= 0; --i) {
      const Vec2 there = i % 2 == 0 ? corner : Vec2(-corner);
      CHECK_NOTHROW(world.add_frame(frame(last - Duration{i}, 1, {{kY3, {there, 3.0}, 1.0}}, {{there, 0.0}})));
    }
    CHECK_NOTHROW(world.add_command(kY3, {last, {sign * kFastest_mps, kFastest_mps, sign * kFastestTurn_radps}}));
    CHECK_NOTHROW(world.state());
  }
}

TEST_CASE("by default vision is as noisy as the league's") {
  CHECK(RobotFilterParams{}.position_sigma_m == 0.0013);
  CHECK(RobotFilterParams{}.heading_sigma_rad == 0.010);
}

TEST_CASE("values that are no measurement are refused by name and change nothing") {
  WorldModel world;
  feed(world, kY3, {}, {}, 0, 100);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const WorldState before = world.state();
  const auto refused = [&](std::vector<RobotDetection> robots, std::vector<BallDetection> balls) {
    CHECK_THROWS_AS(world.add_frame(frame(at_ms(110), 11, std::move(robots), std::move(balls))), std::invalid_argument);
  };
  refused({{kY3, {{nan, 0.0}, 0.0}, 1.0}}, {});
  refused({{kY3, {{0.0, 1e7}, 0.0}, 1.0}}, {});
  refused({{kY3, {{0.0, 0.0}, -std::numeric_limits<double>::infinity()}, 1.0}}, {});
  refused({{kY3, {}, nan}}, {});
  refused({}, {{{0.0, nan}, 1.0}});
  CHECK_THROWS_WITH(world.add_frame(frame(at_ms(110), 11, {{kY3, {{4321.0, 0.0}, 0.0}, 1.0}})),
                    Catch::Contains("Y3") && Catch::Contains("4321"));
  CHECK_THROWS_AS(world.add_frame(frame(from_us(std::numeric_limits<std::int64_t>::min()), 11, {})),
                  std::invalid_argument);
  CHECK_THROWS_AS(world.add_command(kY3, {at_ms(100), {nan, 0.0, 0.0}}), std::invalid_argument);
  WorldState after = world.state();
  after.sequence = before.sequence;
  CHECK(after == before);
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
