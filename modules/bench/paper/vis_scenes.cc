#include "modules/bench/paper/vis_scenes.h"

#include "planning/obstacle_rules.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

RobotState robot_at(Team team, std::size_t number, const Vec2& place) {
  RobotState robot;
  robot.id = {team, static_cast<std::uint16_t>(number)};
  robot.pose.position_m = place;
  return robot;
}

bool is_in_an_area(const Vec2& place, const FieldGeometry& field) {
  return std::abs(place.x()) > field.length_m / 2 - field.defence_depth_m &&
         std::abs(place.y()) < field.defence_width_m / 2;
}

/// In the defence area on that side, two radii from its ends.
Vec2 keeper_place(double side, const FieldGeometry& field, double robot_radius_m, std::mt19937_64& random) {
  const double apart_m = 2.0 * robot_radius_m;
  const double depth_m = uniform(random, 0.0, field.defence_depth_m - apart_m);
  const double across = uniform(random, -0.5, 0.5);
  return {side * (field.length_m / 2 - depth_m), across * (field.defence_width_m - 2.0 * apart_m)};
}

/// What robot `asking` of the world, which is yellow and no keeper, is asked and sees.
Scene scene_of(const WorldState& world, std::size_t asking, const Vec2& goal) {
  const TeamObstacles obstacles = obstacles_for(Team::yellow, division_b(), world, PlanningParams{});
  Scene scene;
  scene.world.bounds = obstacles.field.bounds();
  scene.world.obstacles.assign(obstacles.field.obstacles().begin(), obstacles.field.obstacles().end());
  scene.request.start = world.robots[asking].pose.position_m;
  scene.request.goal = goal;
  scene.request.ignored = ignored_by(obstacles, world.robots[asking].id, false);
  return scene;
}

}  // namespace

Scene wall_scene(const DataTable& wall) {
  WorldState world;
  world.robots.push_back(robot_at(Team::yellow, 1, wall.point("asks_m")));
  for (const Vec2& place : wall.points("robots_m")) {
    world.robots.push_back(robot_at(Team::blue, world.robots.size(), place));
  }
  return scene_of(world, 0, wall.point("goal_m"));
}

Scene agents_scene(std::size_t robots_per_team, std::mt19937_64& random) {
  const FieldGeometry field = division_b();
  const double radius_m = PlanningParams{}.robot_radius_m;
  const Bounds bounds{half_extent(field, radius_m)};
  const std::vector<Vec2> places = places_apart(random, bounds, 2 * (robots_per_team - 1), 2.0 * radius_m,
                                                [&field](const Vec2& place) { return is_in_an_area(place, field); });
  WorldState world;
  for (const Team team : {Team::yellow, Team::blue}) {
    const bool yellow = team == Team::yellow;
    world.robots.push_back(robot_at(team, 0, keeper_place(yellow ? -1.0 : 1.0, field, radius_m, random)));
    for (std::size_t i = 1; i < robots_per_team; ++i) {
      world.robots.push_back(robot_at(team, i, places[i - 1 + (yellow ? 0U : robots_per_team - 1U)]));
    }
  }
  const std::size_t asking = 1 + random() % (robots_per_team - 1);
  Scene scene = scene_of(world, asking, random_point(random, bounds));
  scene.request.seed = random();
  return scene;
}

}  // namespace regista::bench
