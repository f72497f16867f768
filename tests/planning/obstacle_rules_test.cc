// What is an obstacle to whom.
#include "planning/obstacle_rules.h"

#include <catch2/catch.hpp>
#include <limits>

#include "planning/registry.h"

namespace regista {
namespace {

RobotState robot_at(RobotId id, const Vec2& position) {
  RobotState robot;
  robot.id = id;
  robot.pose.position_m = position;
  return robot;
}

WorldState two_robots() {
  WorldState world;
  world.robots = {robot_at({Team::yellow, 3}, {-2, 0}), robot_at({Team::blue, 5}, {2, 1})};
  return world;
}

bool covers(const TeamObstacles& obstacles, std::size_t index, const Vec2& point) {
  return !is_free(point, obstacles.field.obstacles()[index]);
}

}  // namespace

TEST_CASE("robots are discs of both radii and the margin, team-mates' and opponents'") {
  const PlanningParams params;
  const TeamObstacles obstacles = obstacles_for(Team::yellow, division_a(), two_robots(), params);
  REQUIRE(obstacles.robots == std::vector<RobotId>{{Team::yellow, 3}, {Team::blue, 5}});
  CHECK(obstacles.field.obstacles()[0] == disc({-2, 0}, 0.18 + params.team_margin_m));
  CHECK(obstacles.field.obstacles()[1] == disc({2, 1}, 0.18 + params.opponent_margin_m));
  const TeamObstacles blue = obstacles_for(Team::blue, division_a(), two_robots(), params);
  CHECK(blue.field.obstacles()[0] == disc({-2, 0}, 0.18 + params.opponent_margin_m));
}

TEST_CASE("each team has its own area, on the side it defends") {
  FieldGeometry field = division_a();
  const Vec2 left(-5, 0), right(5, 0);
  for (const bool yellow_right : {false, true}) {
    field.yellow_on_positive_x = yellow_right;
    for (const Team team : {Team::yellow, Team::blue}) {
      const bool own_right = (team == Team::yellow) == yellow_right;
      const TeamObstacles obstacles = obstacles_for(team, field, two_robots(), {});
      CHECK(covers(obstacles, obstacles.own_area, own_right ? right : left));
      CHECK_FALSE(obstacles.field.is_free(own_right ? left : right));
      CHECK_FALSE(covers(obstacles, obstacles.own_area, own_right ? left : right));
    }
  }
}

TEST_CASE("a robot ignores itself, and the goalkeeper its own area") {
  const TeamObstacles obstacles = obstacles_for(Team::blue, division_b(), two_robots(), {});
  CHECK(ignored_by(obstacles, {Team::blue, 5}, false) == std::vector<std::size_t>{1});
  CHECK(ignored_by(obstacles, {Team::blue, 5}, true) == std::vector<std::size_t>{1, obstacles.own_area});
  CHECK(ignored_by(obstacles, {Team::blue, 9}, false).empty());
}

TEST_CASE("the goal is entered from the front only") {
  const TeamObstacles obstacles = obstacles_for(Team::yellow, division_a(), WorldState{}, {});
  const std::vector<std::size_t> ignored = ignored_by(obstacles, {Team::yellow, 0}, true);
  CHECK(obstacles.field.is_free({-5, 0}, {-6.0, 0}, ignored));
  CHECK_FALSE(obstacles.field.is_free({-6.05, 1.3}, {-6.05, 0}, ignored));
  CHECK_FALSE(obstacles.field.is_free({-6.5, 0}, {-6, 0}, ignored));
  // The strip between area and wall beside the goal is no pocket to drive into for the others.
  CHECK_FALSE(obstacles.field.is_free({-6.1, 1.5}));
}

TEST_CASE("moving robots are stretched along their velocity when asked for") {
  WorldState world = two_robots();
  world.robots[0].twist.velocity_mps = {2, 0};
  world.robots[1].twist.velocity_mps = {0, 30};
  PlanningParams params;
  params.stretch_horizon_s = 0.25;
  const TeamObstacles obstacles = obstacles_for(Team::yellow, division_a(), world, params);
  CHECK(obstacles.field.obstacles()[0] == capsule({-2, 0}, {-1.5, 0}, 0.18 + params.team_margin_m));
  CHECK((obstacles.field.obstacles()[1].b - Vec2(2, 1 + params.stretch_max_m)).norm() < 1e-12);
}

TEST_CASE("a world or field that makes no sense is refused") {
  WorldState world = two_robots();
  world.robots[0].pose.position_m.x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(obstacles_for(Team::yellow, division_a(), world, {}), std::invalid_argument);
  for (const Twist& twist : {Twist{{0.0, std::numeric_limits<double>::infinity()}, 0.0},
                             Twist{{0.0, 0.0}, std::numeric_limits<double>::quiet_NaN()}}) {
    world = two_robots();
    world.robots[1].twist = twist;
    CHECK_THROWS_WITH(obstacles_for(Team::yellow, division_a(), world, {}), Catch::Contains("B5"));
  }
  FieldGeometry tiny = division_a();
  tiny.length_m = 0.01;
  tiny.margin_goal_line_m = 0.0;
  CHECK_THROWS_AS(obstacles_for(Team::yellow, tiny, two_robots(), {}), std::invalid_argument);
}

}  // namespace regista
