#include "modules/convert/planning.h"

#include "modules/convert/common.h"

namespace regista {
namespace {

target_t to_message(const Target& target) {
  return {number_code(target.robot),  target.pose.position_m.x(),
          target.pose.position_m.y(), target.pose.heading_rad,
          target.speed_max_mps,       static_cast<std::int8_t>(target.may_enter_own_area ? 1 : 0)};
}

Target from_message(const target_t& message) {
  return {number_from(message.robot), pose_from(message.x_m, message.y_m, message.heading_rad),
          at_least(message.speed_max_mps, 0.0, "speed_max_mps"), message.may_enter_own_area != 0};
}

}  // namespace

targets_t MessageOf<Targets>::to_message(const Targets& targets) {
  targets_t message{};
  message.stamp_us = to_us(targets.captured);
  message.team = team_code(targets.team);
  message.sequence = sequence_code(targets.sequence);
  message.target_count = count_of(targets.targets);
  for (const Target& target : targets.targets) message.targets.push_back(regista::to_message(target));
  return message;
}

Targets MessageOf<Targets>::from_message(const targets_t& message) {
  Targets targets;
  targets.captured = time_from(message.stamp_us);
  targets.team = team_from(message.team);
  targets.sequence = sequence_from(message.sequence);
  for (const target_t& target : message.targets) targets.targets.push_back(regista::from_message(target));
  require(strictly_sorted(targets.targets, [](const Target& target) { return target.robot; }),
          "targets are not sorted by robot, or one robot comes twice");
  return targets;
}

plan_t MessageOf<RobotPlan>::to_message(const RobotPlan& robot_plan) {
  const Plan& plan = robot_plan.plan;
  plan_t message{};
  message.stamp_us = to_us(robot_plan.captured);
  message.waypoint_count = count_of(plan.path);
  message.team = team_code(robot_plan.robot.team);
  message.world_sequence = sequence_code(robot_plan.world_sequence);
  message.targets_sequence = sequence_code(robot_plan.targets_sequence);
  message.set_size = static_cast<std::int32_t>(robot_plan.set_size);
  message.generation = sequence_code(robot_plan.generation);
  message.status = static_cast<std::int8_t>(plan.status);
  message.start_moved = plan.start_moved ? 1 : 0;
  message.goal_moved = plan.goal_moved ? 1 : 0;
  message.length_m = plan.length_m;
  message.target = regista::to_message(robot_plan.target);
  message.target.robot = number_code(robot_plan.robot.number);
  for (const Vec2& point : plan.path) message.waypoints.push_back(to_point(point));
  message.planner = robot_plan.planner;
  message.reason = plan.reason;
  return message;
}

RobotPlan MessageOf<RobotPlan>::from_message(const plan_t& message) {
  RobotPlan robot_plan;
  robot_plan.captured = time_from(message.stamp_us);
  robot_plan.target = regista::from_message(message.target);
  robot_plan.robot = {team_from(message.team), robot_plan.target.robot};
  robot_plan.world_sequence = sequence_from(message.world_sequence);
  robot_plan.targets_sequence = sequence_from(message.targets_sequence);
  require(message.set_size >= 1, "set_size is ", message.set_size);
  robot_plan.set_size = static_cast<std::uint32_t>(message.set_size);
  robot_plan.generation = sequence_from(message.generation);
  robot_plan.planner = text_from(message.planner, "planner");
  Plan& plan = robot_plan.plan;
  require(message.status >= 0 && message.status <= static_cast<int>(PlanStatus::invalid), "status is ", message.status,
          ", must be 0 to 3");
  plan.status = static_cast<PlanStatus>(message.status);
  plan.start_moved = message.start_moved != 0;
  plan.goal_moved = message.goal_moved != 0;
  plan.length_m = at_least(message.length_m, 0.0, "length_m");
  for (const point_t& point : message.waypoints) plan.path.push_back(position_from(point.x_m, point.y_m));
  require(plan.status != PlanStatus::ok || !plan.path.empty(), "the plan is ok but has no waypoint");
  plan.reason = text_from(message.reason, "reason");
  return robot_plan;
}

graph_t MessageOf<GraphPicture>::to_message(const GraphPicture& graph) {
  graph_t message{};
  message.stamp_us = to_us(graph.captured);
  message.team = team_code(graph.team);
  message.world_sequence = sequence_code(graph.world_sequence);
  message.node_count = count_of(graph.nodes);
  message.edge_count = count_of(graph.edges);
  for (const Vec2& node : graph.nodes) message.nodes.push_back(to_point(node));
  for (const GraphEdge& edge : graph.edges) {
    message.edges.push_back({static_cast<std::int32_t>(edge.from), static_cast<std::int32_t>(edge.to),
                             static_cast<std::int8_t>(edge.blocked ? 1 : 0)});
  }
  return message;
}

GraphPicture MessageOf<GraphPicture>::from_message(const graph_t& message) {
  GraphPicture graph;
  graph.captured = time_from(message.stamp_us);
  graph.team = team_from(message.team);
  graph.world_sequence = sequence_from(message.world_sequence);
  for (const point_t& node : message.nodes) graph.nodes.push_back(position_from(node.x_m, node.y_m));
  for (const graph_edge_t& edge : message.edges) {
    require(edge.from >= 0 && edge.from < message.node_count && edge.to >= 0 && edge.to < message.node_count, "edge ",
            edge.from, "–", edge.to, " leads out of the ", message.node_count, " nodes");
    graph.edges.push_back(
        {static_cast<std::uint32_t>(edge.from), static_cast<std::uint32_t>(edge.to), edge.blocked != 0});
  }
  return graph;
}

template std::vector<std::uint8_t> encode(const Targets&);
template Targets decode(std::span<const std::uint8_t>);
template std::vector<std::uint8_t> encode(const RobotPlan&);
template RobotPlan decode(std::span<const std::uint8_t>);
template std::vector<std::uint8_t> encode(const GraphPicture&);
template GraphPicture decode(std::span<const std::uint8_t>);

}  // namespace regista
