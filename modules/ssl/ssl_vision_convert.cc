#include "modules/ssl/ssl_vision_convert.h"

#include <google/protobuf/repeated_field.h>

#include <limits>

#include "modules/convert/common.h"
#include "ssl_vision_detection.pb.h"

namespace regista {
namespace {

constexpr double kMillimetresPerMetre = 1e3;  // divided by, so that 1800 mm are 1.8 m to the last bit

// 3,000 years: beyond any clock in use, and far from overflow in microseconds.
constexpr double kLatest_s = 1e11;

Time to_time(double seconds, const char* field) {
  require(std::abs(finite(seconds, field)) <= kLatest_s, field, " is ", seconds);
  return Time{from_seconds(seconds)};
}

double to_confidence(float confidence) { return std::clamp(finite(double{confidence}, "confidence"), 0.0, 1.0); }

Vec2 to_position(float x_mm, float y_mm) {
  return position_from(double{x_mm} / kMillimetresPerMetre, double{y_mm} / kMillimetresPerMetre);
}

bool has_identity(const SSL_DetectionRobot& robot) {
  return robot.has_robot_id() && robot.robot_id() <= std::numeric_limits<std::uint16_t>::max() &&
         robot.has_orientation();
}

void add_robots(const google::protobuf::RepeatedPtrField<SSL_DetectionRobot>& robots, Team team, ConvertedFrame& out) {
  for (const SSL_DetectionRobot& robot : robots) {
    const Vec2 position_m = to_position(robot.x(), robot.y());
    const double confidence = to_confidence(robot.confidence());
    if (!has_identity(robot)) {
      ++out.robots_skipped;
      continue;
    }
    const RobotId id{team, static_cast<std::uint16_t>(robot.robot_id())};
    out.frame.robots.push_back(
        {id, pose_from(position_m.x(), position_m.y(), double{robot.orientation()}), confidence});
  }
}

}  // namespace

ConvertedFrame to_vision_frame(const SSL_DetectionFrame& detection) {
  ConvertedFrame out;
  out.frame.captured = to_time(detection.t_capture(), "t_capture");
  out.frame.sent = to_time(detection.t_sent(), "t_sent");
  out.frame.camera = detection.camera_id();
  out.frame.frame_number = detection.frame_number();
  add_robots(detection.robots_yellow(), Team::yellow, out);
  add_robots(detection.robots_blue(), Team::blue, out);
  for (const SSL_DetectionBall& ball : detection.balls()) {
    out.frame.balls.push_back({to_position(ball.x(), ball.y()), to_confidence(ball.confidence())});
  }
  return out;
}

}  // namespace regista
