#include "modules/convert/vision.h"

#include "modules/convert/common.h"

namespace regista {

vision_frame_t MessageOf<VisionFrame>::to_message(const VisionFrame& frame) {
  vision_frame_t message{};
  message.stamp_us = to_us(frame.captured);
  message.sent_us = to_us(frame.sent);
  message.camera = static_cast<std::int32_t>(frame.camera);
  message.frame_number = static_cast<std::int32_t>(frame.frame_number);
  message.robot_count = count_of(frame.robots);
  message.ball_count = count_of(frame.balls);
  for (const RobotDetection& robot : frame.robots) {
    message.robots.push_back({team_code(robot.id.team), number_code(robot.id.number), robot.pose.position_m.x(),
                              robot.pose.position_m.y(), robot.pose.heading_rad, robot.confidence});
  }
  for (const BallDetection& ball : frame.balls) {
    message.balls.push_back({ball.position_m.x(), ball.position_m.y(), ball.confidence});
  }
  return message;
}

VisionFrame MessageOf<VisionFrame>::from_message(const vision_frame_t& message) {
  VisionFrame frame;
  frame.captured = time_from(message.stamp_us);
  frame.sent = time_from(message.sent_us);
  frame.camera = static_cast<std::uint32_t>(message.camera);
  frame.frame_number = static_cast<std::uint32_t>(message.frame_number);
  for (const robot_detection_t& robot : message.robots) {
    frame.robots.push_back({{team_from(robot.team), number_from(robot.number)},
                            pose_from(robot.x_m, robot.y_m, robot.heading_rad),
                            confidence_from(robot.confidence)});
  }
  for (const ball_detection_t& ball : message.balls) {
    frame.balls.push_back({position_from(ball.x_m, ball.y_m), confidence_from(ball.confidence)});
  }
  return frame;
}

field_geometry_t MessageOf<FieldAnnouncement>::to_message(const FieldAnnouncement& announcement) {
  const FieldGeometry& field = announcement.field;
  field_geometry_t message{};
  message.stamp_us = to_us(announcement.sent);
  message.length_m = field.length_m;
  message.width_m = field.width_m;
  message.margin_goal_line_m = field.margin_goal_line_m;
  message.margin_touch_line_m = field.margin_touch_line_m;
  message.defence_depth_m = field.defence_depth_m;
  message.defence_width_m = field.defence_width_m;
  message.goal_width_m = field.goal_width_m;
  message.goal_depth_m = field.goal_depth_m;
  message.goal_wall_m = field.goal_wall_m;
  message.centre_circle_radius_m = field.centre_circle_radius_m;
  message.yellow_on_positive_x = field.yellow_on_positive_x ? 1 : 0;
  return message;
}

FieldAnnouncement MessageOf<FieldAnnouncement>::from_message(const field_geometry_t& message) {
  constexpr double kSmallest_m = 0.1;  // a field smaller than a robot is a unit error
  FieldGeometry field;
  field.length_m = at_least(message.length_m, kSmallest_m, "length_m");
  field.width_m = at_least(message.width_m, kSmallest_m, "width_m");
  require(field.length_m <= kFarthest_m && field.width_m <= kFarthest_m, "the field is larger than 1 km");
  field.margin_goal_line_m = at_least(message.margin_goal_line_m, 0.0, "margin_goal_line_m");
  field.margin_touch_line_m = at_least(message.margin_touch_line_m, 0.0, "margin_touch_line_m");
  field.defence_depth_m = at_least(message.defence_depth_m, 0.0, "defence_depth_m");
  field.defence_width_m = at_least(message.defence_width_m, 0.0, "defence_width_m");
  field.goal_width_m = at_least(message.goal_width_m, 0.0, "goal_width_m");
  field.goal_depth_m = at_least(message.goal_depth_m, 0.0, "goal_depth_m");
  field.goal_wall_m = at_least(message.goal_wall_m, 0.0, "goal_wall_m");
  field.centre_circle_radius_m = at_least(message.centre_circle_radius_m, 0.0, "centre_circle_radius_m");
  field.yellow_on_positive_x = message.yellow_on_positive_x != 0;
  return {time_from(message.stamp_us), field};
}

template std::vector<std::uint8_t> encode(const VisionFrame&);
template VisionFrame decode(std::span<const std::uint8_t>);
template std::vector<std::uint8_t> encode(const FieldAnnouncement&);
template FieldAnnouncement decode(std::span<const std::uint8_t>);

}  // namespace regista
