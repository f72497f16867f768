#include "planning/obstacle_rules.h"

#include <stdexcept>
#include <string>

#include "planning/game_rules.h"
#include "world_model/types/field_side.h"

namespace regista {
namespace {

/// -1 or 1: the side of x on which a team's goal stands.
double side_of(Team team, const FieldGeometry& field) { return defends_negative_x(team, field) ? -1.0 : 1.0; }

void check(const RobotState& robot) {
  const Vec2& place = robot.pose.position_m;
  const Vec2& velocity = robot.twist.velocity_mps;
  if (is_finite(place) && is_finite(velocity) && std::isfinite(robot.twist.angular_radps)) return;
  throw std::invalid_argument("robot " + to_string(robot.id) + " must be finite, is at (" + std::to_string(place.x()) +
                              ", " + std::to_string(place.y()) + ") m and moves with (" + std::to_string(velocity.x()) +
                              ", " + std::to_string(velocity.y()) + ") m/s, " +
                              std::to_string(robot.twist.angular_radps) + " rad/s");
}

Obstacle robot_obstacle(const RobotState& robot, Team team, const PlanningParams& params) {
  const double margin_m = robot.id.team == team ? params.team_margin_m : params.opponent_margin_m;
  const double radius_m = 2.0 * params.robot_radius_m + margin_m;
  const Vec2 stretch = clamped_norm(robot.twist.velocity_mps * params.stretch_horizon_s, params.stretch_max_m);
  // Vision noise makes standing robots creep; a stretch below a millimetre is none.
  constexpr double kLeastStretch_m = 1e-3;
  if (!(stretch.norm() >= kLeastStretch_m)) return disc(robot.pose.position_m, radius_m);
  return capsule(robot.pose.position_m, robot.pose.position_m + stretch, radius_m);
}

/// From the area's front to the rear of the goal: the strip beside the goal is a dead end nobody should try.
Obstacle area_obstacle(double side, const FieldGeometry& field, double robot_radius_m, double margin_m) {
  const double front_m = field.length_m / 2 - field.defence_depth_m;
  const double rear_m = field.length_m / 2 + field.goal_depth_m + field.goal_wall_m;
  return rounded_rectangle({side * front_m, -field.defence_width_m / 2}, {side * rear_m, field.defence_width_m / 2},
                           robot_radius_m + margin_m);
}

/// The two side walls and the rear wall; goal_depth_m and goal_width_m are the goal's inner measures.
void append_goal_walls(double side, const FieldGeometry& field, const PlanningParams& params,
                       std::vector<Obstacle>& out) {
  const double radius_m = params.robot_radius_m + params.wall_margin_m;
  const double line_m = field.length_m / 2;
  const double inner_m = line_m + field.goal_depth_m;
  const double outer_m = inner_m + field.goal_wall_m;
  const double post_m = field.goal_width_m / 2;
  for (const double y : {-1.0, 1.0}) {
    out.push_back(
        rounded_rectangle({side * line_m, y * post_m}, {side * outer_m, y * (post_m + field.goal_wall_m)}, radius_m));
  }
  out.push_back(rounded_rectangle({side * inner_m, -post_m}, {side * outer_m, post_m}, radius_m));
}

}  // namespace

std::vector<Obstacle> static_obstacles(Team team, const FieldGeometry& field, const WorldState& world,
                                       const Situation& situation, const PlanningParams& params) {
  const double radius_m = params.robot_radius_m;
  const double opponent_margin_m = std::max(params.area_margin_m, rule_area_distance(situation, params.rules));
  std::vector<Obstacle> out{area_obstacle(side_of(team, field), field, radius_m, params.area_margin_m),
                            area_obstacle(side_of(opponent_of(team), field), field, radius_m, opponent_margin_m)};
  append_goal_walls(-1.0, field, params, out);
  append_goal_walls(1.0, field, params, out);
  for (const Obstacle& shape : rule_obstacles(team, world, situation, params.rules, radius_m)) {
    if (!is_valid(shape)) throw std::invalid_argument("the ball or the place for it must be finite");
    out.push_back(shape);
  }
  return out;
}

TeamObstacles obstacles_for(Team team, const FieldGeometry& field, const WorldState& world,
                            const PlanningParams& params, const Situation& situation) {
  TeamObstacles out;
  std::vector<Obstacle> obstacles;
  for (const RobotState& robot : world.robots) {
    check(robot);
    obstacles.push_back(robot_obstacle(robot, team, params));
    out.robots.push_back(robot.id);
  }
  out.own_area = obstacles.size() + kOwnArea;
  const std::vector<Obstacle> still = static_obstacles(team, field, world, situation, params);
  obstacles.insert(obstacles.end(), still.begin(), still.end());
  out.field = ObstacleField({half_extent(field, params.robot_radius_m)}, std::move(obstacles));
  return out;
}

std::vector<std::size_t> ignored_by(const TeamObstacles& obstacles, RobotId id, bool may_enter_own_area) {
  std::vector<std::size_t> ignored;
  for (std::size_t i = 0; i < obstacles.robots.size(); ++i) {
    if (obstacles.robots[i] == id) ignored.push_back(i);
  }
  if (may_enter_own_area) ignored.push_back(obstacles.own_area);
  return ignored;
}

}  // namespace regista
