#include "modules/convert/world.h"

#include "modules/convert/common.h"

namespace regista {
namespace {

robot_state_t to_message(const RobotState& robot) {
  return {team_code(robot.id.team),      number_code(robot.id.number), robot.pose.position_m.x(),
          robot.pose.position_m.y(),     robot.pose.heading_rad,       robot.twist.velocity_mps.x(),
          robot.twist.velocity_mps.y(),  robot.twist.angular_radps,    robot.position_variance_m2,
          robot.velocity_variance_m2ps2, robot.heading_variance_rad2,  robot.age.count()};
}

RobotState from_message(const robot_state_t& message) {
  RobotState robot;
  robot.id = {team_from(message.team), number_from(message.number)};
  robot.pose = pose_from(message.x_m, message.y_m, message.heading_rad);
  robot.twist = {velocity_from(message.vx_mps, message.vy_mps), turn_from(message.angular_radps)};
  robot.position_variance_m2 = at_least(message.position_variance_m2, 0.0, "position_variance_m2");
  robot.velocity_variance_m2ps2 = at_least(message.velocity_variance_m2ps2, 0.0, "velocity_variance_m2ps2");
  robot.heading_variance_rad2 = at_least(message.heading_variance_rad2, 0.0, "heading_variance_rad2");
  robot.age = age_from(message.age_us);
  return robot;
}

ball_state_t to_message(const BallState& ball) {
  return {ball.position_m.x(),       ball.position_m.y(),          ball.velocity_mps.x(), ball.velocity_mps.y(),
          ball.position_variance_m2, ball.velocity_variance_m2ps2, ball.age.count()};
}

BallState from_message(const ball_state_t& message) {
  BallState ball;
  ball.position_m = position_from(message.x_m, message.y_m);
  ball.velocity_mps = velocity_from(message.vx_mps, message.vy_mps);
  ball.position_variance_m2 = at_least(message.position_variance_m2, 0.0, "position_variance_m2");
  ball.velocity_variance_m2ps2 = at_least(message.velocity_variance_m2ps2, 0.0, "velocity_variance_m2ps2");
  ball.age = age_from(message.age_us);
  return ball;
}

}  // namespace

world_state_t MessageOf<WorldState>::to_message(const WorldState& world) {
  world_state_t message{};
  message.stamp_us = to_us(world.captured);
  message.valid_at_us = to_us(world.valid_at);
  message.sequence = sequence_code(world.sequence);
  message.robot_count = count_of(world.robots);
  message.ball_count = world.ball ? 1 : 0;
  for (const RobotState& robot : world.robots) message.robots.push_back(regista::to_message(robot));
  if (world.ball) message.balls.push_back(regista::to_message(*world.ball));
  return message;
}

WorldState MessageOf<WorldState>::from_message(const world_state_t& message) {
  WorldState world;
  world.captured = time_from(message.stamp_us);
  world.valid_at = time_from(message.valid_at_us);
  world.sequence = sequence_from(message.sequence);
  for (const robot_state_t& robot : message.robots) world.robots.push_back(regista::from_message(robot));
  require(strictly_sorted(world.robots, [](const RobotState& robot) { return robot.id; }),
          "robots are not sorted by team and number, or one comes twice");
  require(message.ball_count <= 1, "ball_count is ", message.ball_count, ", must be 0 or 1");
  if (message.ball_count == 1) world.ball = regista::from_message(message.balls.front());
  return world;
}

template std::vector<std::uint8_t> encode(const WorldState&);
template WorldState decode(std::span<const std::uint8_t>);

}  // namespace regista
