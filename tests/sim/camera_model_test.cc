#include "sim/camera_model.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace regista {
namespace {

// Mean and standard deviation of what it was fed.
struct Statistics {
  double sum = 0.0;
  double squares = 0.0;
  int count = 0;
  void add(double value) {
    sum += value;
    squares += value * value;
    ++count;
  }
  double mean() const { return sum / count; }
  double sigma() const { return std::sqrt(squares / count - mean() * mean()); }
};

TEST_CASE("noise and losses are those of the parameters") {
  VisionParams params;
  params.robot_sigma_m = 0.0013;
  params.heading_sigma_rad = 0.01;
  params.ball_sigma_m = 0.0014;
  params.robot_dropout = 0.02;
  params.ball_dropout = 0.05;
  const std::vector<RobotBody> robots{{{Team::yellow, 4}, {{1.0, -2.0}, 0.5}, {}}, {{Team::blue, 0}, {{0, 0}, 0}, {}}};
  BallBody ball;
  ball.position_m = {3.0, 1.0};
  Camera camera(0, params, 11, Time{});
  Statistics x, y, heading, ball_x, ball_y;
  const int frames = 20000;
  for (int i = 0; i < frames; ++i) {
    const VisionFrame frame = camera.capture(robots, ball, camera.next_capture());
    for (const RobotDetection& robot : frame.robots) {
      if (robot.id.team == Team::blue) continue;
      x.add(robot.pose.position_m.x() - 1.0);
      y.add(robot.pose.position_m.y() + 2.0);
      heading.add(robot.pose.heading_rad - 0.5);
    }
    for (const BallDetection& seen : frame.balls) {
      ball_x.add(seen.position_m.x() - 3.0);
      ball_y.add(seen.position_m.y() - 1.0);
    }
  }
  // Bounds of five standard errors: σ/√n for the mean, σ/√(2n) for σ, √(p(1-p)/n) for a rate; n about 20,000.
  const auto matches = [](const Statistics& seen, double sigma) {
    CHECK(std::abs(seen.mean()) < 5.0 * sigma / std::sqrt(seen.count));
    CHECK(std::abs(seen.sigma() - sigma) < 5.0 * sigma / std::sqrt(2.0 * seen.count));
  };
  matches(x, 0.0013);
  matches(y, 0.0013);
  matches(heading, 0.01);
  matches(ball_x, 0.0014);
  matches(ball_y, 0.0014);
  CHECK(1.0 - static_cast<double>(x.count) / frames == Approx(0.02).margin(0.005));
  CHECK(1.0 - static_cast<double>(ball_x.count) / frames == Approx(0.05).margin(0.008));
}

TEST_CASE("without noise the camera tells the truth, late by its latency") {
  VisionParams params;
  params.rate_hz = 60.0;
  params.latency_s = 0.045;
  Camera camera(2, params, 1, from_us(5000));
  const RobotBody robot{{Team::blue, 7}, {{1.0, 2.0}, 3.0}, {}};
  for (std::uint32_t k = 0; k < 61; ++k) {
    const Time due = camera.next_capture();
    const VisionFrame frame = camera.capture({robot}, {}, due);
    CHECK(frame.captured == due);
    CHECK(frame.sent - frame.captured == Duration{45000});
    CHECK(frame.camera == 2);
    CHECK(frame.frame_number == k);
    REQUIRE(frame.robots.size() == 1);
    CHECK(frame.robots[0].id == robot.id);
    CHECK(frame.robots[0].pose == robot.pose);
  }
  CHECK(camera.next_capture() == from_us(5000 + 1'016'667));  // 61/60 s: no drift
}

TEST_CASE("cameras together see all of the field, two at most where they overlap and four where four meet") {
  for (const std::int64_t cameras : {1, 2, 3, 4, 6, 8}) {
    CAPTURE(cameras);
    VisionParams params;
    params.cameras = cameras;
    const auto seen_by = [&](const Vec2& place) {
      int count = 0;
      for (std::uint32_t i = 0; i < cameras; ++i) count += sees(camera_view(division_a(), i, params), place);
      return count;
    };
    double overlap_m = 0.0;  // along y = 1
    for (double x = -6.595; x < 6.6; x += 0.01) {
      for (const double y : {-4.7, -1.0, 1.0, 4.7}) REQUIRE(seen_by({x, y}) >= 1);
      REQUIRE(seen_by({x, 1.0}) <= 2);
      if (seen_by({x, 1.0}) == 2) overlap_m += 0.01;
    }
    const auto columns = static_cast<double>(cameras > 2 && cameras % 2 == 0 ? cameras / 2 : cameras);
    CHECK(overlap_m == Approx((columns - 1.0) * 0.3).margin(0.011 * columns));
    if (cameras == 4) CHECK(seen_by({0.0, 0.0}) == 4);
  }
}

TEST_CASE("a camera is off by its own shift, the same in every frame, and sees nothing beyond its view") {
  VisionParams params;
  params.camera_shift_max_m = 0.02;
  const std::vector<RobotBody> robots{{{Team::yellow, 4}, {{1.0, -2.0}, 0.5}, {}}, {{Team::blue, 0}, {{-1, 0}, 0}, {}}};
  BallBody ball;
  ball.position_m = {3.0, 1.0};
  double farthest_m = 0.0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Camera camera(1, params, seed, Time{}, {{0.0, -10.0}, {10.0, 10.0}});
    CHECK(camera.shift_m().norm() <= 0.02);
    farthest_m = std::max(farthest_m, camera.shift_m().norm());
    for (int i = 0; i < 3; ++i) {
      const VisionFrame frame = camera.capture(robots, ball, camera.next_capture());
      REQUIRE(frame.robots.size() == 1);
      CHECK((frame.robots[0].pose.position_m - robots[0].pose.position_m - camera.shift_m()).norm() < 1e-12);
      CHECK((frame.balls.at(0).position_m - ball.position_m - camera.shift_m()).norm() < 1e-12);
    }
    CHECK(camera.shift_m() == Camera(2, params, seed, Time{}).shift_m());
  }
  CHECK(farthest_m > 0.018);
}

}  // namespace
}  // namespace regista
