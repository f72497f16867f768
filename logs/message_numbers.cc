#include "logs/message_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "modules/bus/channels.h"
#include "modules/convert/commands.h"
#include "modules/convert/planning.h"
#include "modules/convert/referee.h"
#include "modules/convert/vision.h"
#include "modules/convert/world.h"

namespace regista {
namespace {

class Flattener {
 public:
  void number(double value) { out_.numbers.push_back({value, false}); }
  void angle(double value_rad) { out_.numbers.push_back({value_rad, true}); }
  void point(const Vec2& p) {
    number(p.x());
    number(p.y());
  }
  void pose(const Pose& pose) {
    point(pose.position_m);
    angle(pose.heading_rad);
  }
  void seconds(Duration duration) { number(to_seconds(duration)); }
  void exact(const std::string& text) { out_.rest += text + ";"; }
  void exact(std::uint64_t value) { exact(std::to_string(value)); }
  MessageNumbers take() { return std::move(out_); }

 private:
  MessageNumbers out_;
};

void flatten(const WorldState& world, Flattener& out) {
  for (const RobotState& robot : world.robots) {
    out.exact(to_string(robot.id));
    out.pose(robot.pose);
    out.point(robot.twist.velocity_mps);
    out.number(robot.twist.angular_radps);
    out.number(robot.position_variance_m2);
    out.number(robot.velocity_variance_m2ps2);
    out.number(robot.heading_variance_rad2);
    out.seconds(robot.age);
  }
  out.exact(world.ball ? "ball" : "no ball");
  if (!world.ball) return;
  out.point(world.ball->position_m);
  out.point(world.ball->velocity_mps);
  out.number(world.ball->position_variance_m2);
  out.number(world.ball->velocity_variance_m2ps2);
  out.seconds(world.ball->age);
}

void flatten(const VisionFrame& frame, Flattener& out) {
  out.exact(frame.camera);
  for (const RobotDetection& robot : frame.robots) {
    out.exact(to_string(robot.id));
    out.pose(robot.pose);
    out.number(robot.confidence);
  }
  for (const BallDetection& ball : frame.balls) {
    out.exact("ball");
    out.point(ball.position_m);
    out.number(ball.confidence);
  }
}

void flatten(const FieldAnnouncement& announcement, Flattener& out) {
  const FieldGeometry& field = announcement.field;
  for (const double length_m : {field.length_m, field.width_m, field.margin_goal_line_m, field.margin_touch_line_m,
                                field.defence_depth_m, field.defence_width_m, field.goal_width_m, field.goal_depth_m,
                                field.goal_wall_m, field.centre_circle_radius_m}) {
    out.number(length_m);
  }
  out.exact(field.yellow_on_positive_x ? "yellow +x" : "yellow -x");
}

void flatten(const TeamRecord& record, Flattener& out) {
  for (const std::uint32_t count : {record.score, record.yellow_cards, record.red_cards}) out.exact(count);
  out.exact(record.goalkeeper);
}

void flatten(const GameState& game, Flattener& out) {
  out.exact(static_cast<std::uint64_t>(game.stage));
  out.exact(command_text(game.command, game.team));
  out.exact(game.command_counter);
  out.exact(game.placement_m ? "placement" : "");
  if (game.placement_m) out.point(*game.placement_m);
  flatten(game.yellow, out);
  flatten(game.blue, out);
}

void flatten(const Target& target, Flattener& out) {
  out.exact(target.robot);
  out.pose(target.pose);
  out.number(target.speed_max_mps);
  out.exact(target.may_enter_own_area ? "may enter" : "");
}

void flatten(const Targets& targets, Flattener& out) {
  for (const Target& target : targets.targets) flatten(target, out);
}

void flatten(const RobotPlan& plan, Flattener& out) {
  out.exact(to_string(plan.robot));
  out.exact(plan.set_size);
  out.exact(plan.planner);
  flatten(plan.target, out);
  out.exact(name(plan.plan.status));
  out.exact(plan.plan.start_moved ? "start moved" : "");
  out.exact(plan.plan.goal_moved ? "goal moved" : "");
  for (const Vec2& waypoint : plan.plan.path) out.point(waypoint);
  out.number(plan.plan.length_m);
}

void flatten(const GraphPicture& graph, Flattener& out) {
  for (const Vec2& node : graph.nodes) out.point(node);
  for (const GraphEdge& edge : graph.edges) {
    out.exact(std::to_string(edge.from) + "-" + std::to_string(edge.to) + (edge.blocked ? "x" : ""));
  }
}

void flatten(const TeamCommands& commands, Flattener& out) {
  for (const RobotCommand& command : commands.commands) {
    out.exact(command.robot);
    out.number(command.velocity.forward_mps);
    out.number(command.velocity.left_mps);
    out.number(command.velocity.angular_radps);
    for (const double speed_radps : command.wheel_speeds_radps) out.number(speed_radps);
    out.number(command.kick_speed_mps);
    out.number(command.dribbler_radps);
  }
}

template <class Value>
MessageNumbers numbers_of(std::span<const std::uint8_t> bytes) {
  Flattener out;
  flatten(decode<Value>(bytes), out);
  return out.take();
}

}  // namespace

std::optional<MessageNumbers> message_numbers(const std::string& channel, std::span<const std::uint8_t> bytes) {
  const std::string base = channel.substr(0, channel.find('.'));
  if (base == "VISION") return numbers_of<VisionFrame>(bytes);
  if (base == "GEOMETRY") return numbers_of<FieldAnnouncement>(bytes);
  if (base == "REFEREE") return numbers_of<GameState>(bytes);
  if (base == "WORLD_STATE" || base == "TRUTH") return numbers_of<WorldState>(bytes);
  if (base == "TARGETS") return numbers_of<Targets>(bytes);
  if (base == "PLAN") return numbers_of<RobotPlan>(bytes);
  if (base == "GRAPH") return numbers_of<GraphPicture>(bytes);
  if (base == "COMMANDS") return numbers_of<TeamCommands>(bytes);
  return std::nullopt;
}

double difference(const MessageNumbers& a, const MessageNumbers& b) {
  if (a.rest != b.rest || a.numbers.size() != b.numbers.size()) return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t i = 0; i < a.numbers.size(); ++i) {
    const double apart = a.numbers[i].value - b.numbers[i].value;
    largest = std::max(largest, std::abs(a.numbers[i].is_angle ? wrap_angle(apart) : apart));
  }
  return largest;
}

}  // namespace regista
