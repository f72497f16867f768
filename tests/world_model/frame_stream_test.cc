// The world model under the frames that come: late, twice, from two cameras, from a clock that starts again, from far
// away, and full of what is no measurement.
#include <catch2/catch.hpp>
#include <limits>
#include <stdexcept>

#include "tests/world_model/scene.h"
#include "world_model/types/plausible.h"
#include "world_model/world_model.h"

namespace regista {
namespace {

using test::at_ms;
using test::feed;
using test::frame;
using test::kB0;
using test::kY3;

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

TEST_CASE("a simulator that starts again is followed, with nothing left from before") {
  WorldModel world;
  feed(world, kY3, {}, {}, 60000, 61000);
  feed(world, kB0, {}, {}, 0, 100);
  const WorldState state = world.state();
  CHECK(state.captured == at_ms(100));
  REQUIRE(state.robots.size() == 1);
  CHECK(state.robots[0].id == kB0);
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

}  // namespace
}  // namespace regista
