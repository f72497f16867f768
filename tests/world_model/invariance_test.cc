// The estimate does not depend on where the field lies, how it is turned, or the order detections are listed in; the
// same input gives the same bytes.
#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/world_model/scene.h"

namespace regista {
namespace {

/// A scene of 22 robots and a ball with noise, misses, false balls and two cameras, as frames.
std::vector<VisionFrame> noisy_frames(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<VisionFrame> frames;
  for (std::uint32_t i = 0; i < 150; ++i) {
    for (std::uint32_t camera = 0; camera < 2; ++camera) {
      VisionFrame frame = test::frame(test::at_ms(10.0 * i - 3.0 * camera), i, {}, {}, camera);
      const double t = to_seconds(frame.captured.time_since_epoch());
      for (std::uint16_t n = 0; n < 22; ++n) {
        if (random() % 50 == 0) continue;
        const Pose pose{{-4.0 + 0.4 * n + 0.5 * std::sin(2.0 * t + n), 2.0 * std::cos(t + n)}, wrap_angle(5.0 * t + n)};
        const Vec2 noise = Vec2(test::normal(random), test::normal(random)) * 0.0013;
        frame.robots.push_back({{n < 11 ? Team::yellow : Team::blue, static_cast<std::uint16_t>(n % 11)},
                                {pose.position_m + noise, wrap_angle(pose.heading_rad + 0.01 * test::normal(random))},
                                test::uniform(random, 0.5, 1.0)});
      }
      frame.balls.push_back({{t, 0.0014 * test::normal(random)}, 1.0});
      if (random() % 20 == 0) frame.balls.push_back({{test::uniform(random, -4, 4), 3.0}, 1.0});
      frames.push_back(frame);
    }
  }
  return frames;
}

WorldState run(const std::vector<VisionFrame>& frames) {
  WorldModel world;
  for (const VisionFrame& frame : frames) world.add_frame(frame);
  return world.state();
}

TEST_CASE("same frames, same bytes; the order of detections in a frame does not matter") {
  std::vector<VisionFrame> frames = noisy_frames(12);
  const WorldState once = run(frames);
  REQUIRE(once.robots.size() == 22);
  REQUIRE(once.ball);
  CHECK(run(frames) == once);
  for (VisionFrame& frame : frames) {
    std::reverse(frame.robots.begin(), frame.robots.end());
    std::reverse(frame.balls.begin(), frame.balls.end());
  }
  CHECK(run(frames) == once);
  CHECK_FALSE(run(noisy_frames(13)) == once);
}

TEST_CASE("a moved and turned field gives the moved and turned estimate") {
  const std::vector<VisionFrame> frames = noisy_frames(14);
  const WorldState still = run(frames);
  std::mt19937_64 random(15);
  for (int i = 0; i < 10; ++i) {
    const double turn = test::uniform(random, -3.1, 3.1);
    const Vec2 shift(test::uniform(random, -20, 20), test::uniform(random, -20, 20));
    CAPTURE(turn, shift.x(), shift.y());
    const auto placed = [&](const Vec2& p) { return Vec2(rotated(p, turn) + shift); };
    std::vector<VisionFrame> other = frames;
    for (VisionFrame& frame : other) {
      for (RobotDetection& robot : frame.robots) {
        robot.pose = {placed(robot.pose.position_m), wrap_angle(robot.pose.heading_rad + turn)};
      }
      for (BallDetection& ball : frame.balls) ball.position_m = placed(ball.position_m);
    }
    const WorldState world = run(other);
    REQUIRE(world.robots.size() == still.robots.size());
    for (std::size_t r = 0; r < still.robots.size(); ++r) {
      const RobotState& a = still.robots[r];
      const RobotState& b = world.robots[r];
      REQUIRE((placed(a.pose.position_m) - b.pose.position_m).norm() < 1e-9);
      REQUIRE((rotated(a.twist.velocity_mps, turn) - b.twist.velocity_mps).norm() < 1e-8);
      REQUIRE(std::abs(wrap_angle(a.pose.heading_rad + turn - b.pose.heading_rad)) < 1e-9);
      REQUIRE(a.position_variance_m2 == b.position_variance_m2);
    }
    REQUIRE((placed(still.ball->position_m) - world.ball->position_m).norm() < 1e-9);
    REQUIRE((rotated(still.ball->velocity_mps, turn) - world.ball->velocity_mps).norm() < 1e-8);
  }
}

}  // namespace
}  // namespace regista
