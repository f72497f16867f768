#include "sim/camera_model.h"

#include <cmath>
#include <numbers>

namespace regista {

namespace {

// A stream of its own: a camera that is off makes the same noise as one that is not.
constexpr std::uint64_t kShiftStream = 1;

/// Evenly spread over the disc of that radius.
Vec2 drawn_shift(std::uint64_t seed, double radius_m) {
  Random random(mixed(seed, kShiftStream));
  const double distance_m = radius_m * std::sqrt(random.uniform());
  return rotated({distance_m, 0.0}, random.uniform(-std::numbers::pi, std::numbers::pi));
}

}  // namespace

Camera::Camera(std::uint32_t number, const VisionParams& params, std::uint64_t seed, Time start, const CameraView& view)
    : number_(number),
      params_(params),
      random_(seed),
      start_(start),
      view_(view),
      shift_m_(drawn_shift(seed, params.camera_shift_max_m)) {}

Time Camera::next_capture() const { return start_ + from_seconds(frames_ / params_.rate_hz); }

VisionFrame Camera::capture(const std::vector<RobotBody>& robots, const BallBody& ball, Time now) {
  VisionFrame frame;
  frame.captured = now;
  frame.sent = now + latency();
  frame.camera = number_;
  frame.frame_number = frames_++;
  frame.robots.reserve(robots.size());
  const auto noise = [this](double sigma_m) {
    const double x = random_.normal();
    const double y = random_.normal();
    return Vec2(sigma_m * x, sigma_m * y);
  };
  // Every object draws its numbers whether seen or not, so that one parameter does not shift the noise of another.
  for (const RobotBody& robot : robots) {
    const bool missing = random_.chance(params_.robot_dropout);
    const Vec2 position = robot.pose.position_m + shift_m_ + noise(params_.robot_sigma_m);
    const double heading = robot.pose.heading_rad + params_.heading_sigma_rad * random_.normal();
    if (!missing && sees(view_, robot.pose.position_m))
      frame.robots.push_back({robot.id, {position, wrap_angle(heading)}, 1.0});
  }
  const bool missing = random_.chance(params_.ball_dropout);
  const Vec2 position = ball.position_m + shift_m_ + noise(params_.ball_sigma_m);
  if (!missing && sees(view_, ball.position_m)) frame.balls.push_back({position, 1.0});
  return frame;
}

}  // namespace regista
