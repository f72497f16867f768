#include <algorithm>
#include <cmath>
#include <numbers>

#include "modules/viewer/layers.h"
#include "modules/viewer/scene_drawing.h"
#include "world_model/types/robot_limits.h"

namespace regista {
namespace {

constexpr double kRobotRadius_m = RobotLimits{}.radius_m;
constexpr double kRobotFront_m = 0.07;  // the dribbler's flat front, as most robots of the league have it
constexpr int kRobotCorners = 32;

// Shown twice as large as it is (0.0215 m), or it would be three pixels wide.
constexpr double kBallRadius_m = 0.043;

/// Widths that stay readable: metres on a 12 m field, more on larger ones. Robots keep their true size.
struct Style {
  double scale;
  double path_m = 0.032 * scale;
  double path_edge_m = 0.058 * scale;
  double link_m = 0.012 * scale;
  double edge_m = 0.011 * scale;
  double node_radius_m = 0.02 * scale;
  double ring_m = 0.028 * scale;
  double target_radius_m = 0.085 * scale;
  double number_m = 0.17 * scale;
  double stroke_m = 0.03 * scale;
  double halo_m = 0.075 * scale;
};

Style style_of(const FieldGeometry& field) { return {std::max(1.0, field.length_m / 12.0)}; }

void draw_graph(Drawing& drawing, const GraphPicture& graph, const Style& style) {
  const Color free = mixed(palette::kGrass, color_of(graph.team), 0.42);
  const Color node = mixed(palette::kGrass, color_of(graph.team), 0.65);
  const std::size_t nodes = graph.nodes.size();
  for (const GraphEdge& edge : graph.edges) {
    // Blocked edges are left out: they outnumber the free ones so much that they would smear over the field.
    if (edge.blocked || edge.from >= nodes || edge.to >= nodes) continue;
    add_segment(drawing, graph.nodes[edge.from], graph.nodes[edge.to], style.edge_m, {layers::kGraph_m, free});
  }
  for (const Vec2& point : graph.nodes) add_disc(drawing, point, style.node_radius_m, {layers::kFieldLine_m, node});
}

void draw_plan(Drawing& drawing, const RobotPlan& plan, const Style& style) {
  const Color color = plan.plan.status == PlanStatus::ok ? color_of(plan.robot.team) : palette::kWarning;
  add_polyline(drawing, plan.plan.path, style.path_edge_m, {layers::kPathEdge_m, palette::kInk});
  add_polyline(drawing, plan.plan.path, style.path_m, {layers::kPath_m, color});
}

void draw_target(Drawing& drawing, const Target& target, Team team, const Style& style) {
  const Vec2& centre = target.pose.position_m;
  const double dark_m = (style.path_edge_m - style.path_m) + style.ring_m;
  add_ring(drawing, centre, style.target_radius_m, dark_m, {layers::kPathEdge_m, palette::kInk});
  add_ring(drawing, centre, style.target_radius_m, style.ring_m, {layers::kTarget_m, color_of(team)});
  add_disc(drawing, centre, style.ring_m, {layers::kTarget_m, color_of(team)});
}

/// The outline seen from above: a disc with a flat front.
std::vector<Vec2> robot_outline(const Pose& pose, double margin_m) {
  const double radius = kRobotRadius_m + margin_m;
  const double half_opening = std::acos((kRobotFront_m + margin_m) / radius);
  std::vector<Vec2> corners;
  for (int i = 0; i < kRobotCorners; ++i) {
    const double share = static_cast<double>(i) / (kRobotCorners - 1);
    const double angle = half_opening + share * 2.0 * (std::numbers::pi - half_opening);
    corners.push_back(pose.position_m + radius * rotated({1.0, 0.0}, pose.heading_rad + angle));
  }
  return corners;
}

void draw_robot(Drawing& drawing, const RobotState& robot, const Style& style) {
  const Color color = color_of(robot.id.team);
  const std::vector<Vec2> body = robot_outline(robot.pose, 0.0);
  add_polygon(drawing, robot_outline(robot.pose, style.stroke_m * 0.5), {layers::kRobotEdge_m, palette::kInk});
  add_wall(drawing, body, layers::kGrass_m, {layers::kRobot_m, mixed(color, palette::kInk, 0.4)});
  add_polygon(drawing, body, {layers::kRobot_m, color});
  const Vec2 forward = rotated({1.0, 0.0}, robot.pose.heading_rad);
  const Vec2& centre = robot.pose.position_m;
  add_segment(drawing, centre, centre + kRobotFront_m * forward, 0.03, {layers::kRobotFront_m, palette::kInk});
  const Vec2 label = robot.pose.position_m + Vec2(0.0, kRobotRadius_m + 0.75 * style.number_m);
  add_number(drawing, robot.id.number, label, style.number_m, style.halo_m, {layers::kNumberEdge_m, palette::kInk});
  add_number(drawing, robot.id.number, label, style.number_m, style.stroke_m,
             {layers::kNumber_m, mixed(color, palette::kWhite, 0.5)});
}

void draw_team(Drawing& drawing, const ViewerScene& scene, Team team, const Style& style) {
  const TeamScene& play = scene.of(team);
  if (play.graph) draw_graph(drawing, *play.graph, style);
  for (const auto& [number, plan] : play.plans) draw_plan(drawing, plan, style);
  if (!play.targets) return;
  for (const Target& target : play.targets->targets) {
    draw_target(drawing, target, team, style);
    const RobotState* robot = find_robot(scene.world, {team, target.robot});
    if (robot == nullptr || play.plans.contains(target.robot)) continue;
    add_segment(drawing, robot->pose.position_m, target.pose.position_m, style.link_m,
                {layers::kLink_m, mixed(palette::kGrass, color_of(team), 0.7)});
  }
}

}  // namespace

Drawing draw_play(const ViewerScene& scene) {
  const Style style = style_of(scene.field);
  Drawing drawing;
  for (const Team team : {Team::yellow, Team::blue}) draw_team(drawing, scene, team, style);
  for (const RobotState& robot : scene.world.robots) draw_robot(drawing, robot, style);
  if (scene.world.ball) {
    const Vec2& ball = scene.world.ball->position_m;
    add_disc(drawing, ball, 1.4 * kBallRadius_m, {layers::kBallEdge_m, palette::kInk});
    add_disc(drawing, ball, kBallRadius_m, {layers::kBall_m, palette::kBall});
  }
  return drawing;
}

}  // namespace regista
