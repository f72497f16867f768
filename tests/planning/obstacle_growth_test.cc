// Obstacles that grow with their distance from the goal: the law, and what it must never cost.
#include "planning/obstacle_growth.h"

#include <catch2/catch.hpp>

#include "planning/clearance.h"
#include "planning/team_planner.h"
#include "planning/uniform.h"
#include "tests/support/planning_oracles.h"
#include "tests/support/planning_worlds.h"

namespace regista {
namespace {

constexpr double kRadius_m = 0.21;
constexpr double kRadiusMax_m = 0.4;

PlanningParams growing() {
  PlanningParams params;
  params.growth_radius_max_m = kRadiusMax_m;
  return params;
}

WorldState world_of(const std::vector<Vec2>& yellow, const std::vector<Vec2>& blue) {
  WorldState world;
  world.sequence = 1;
  for (const Team team : {Team::yellow, Team::blue}) {
    std::uint16_t number = 0;
    for (const Vec2& place : team == Team::yellow ? yellow : blue) {
      RobotState robot;
      robot.id = {team, number++};
      robot.pose.position_m = place;
      world.robots.push_back(robot);
    }
  }
  return world;
}

Targets target_at(const Vec2& goal) {
  Targets targets;
  targets.targets.resize(1);
  targets.targets[0].pose.position_m = goal;
  return targets;
}

double nearest_pass_m(const Plan& plan, const Vec2& point) {
  double nearest_m = 1e9;
  for (std::size_t i = 1; i < plan.path.size(); ++i) {
    nearest_m = std::min(nearest_m, clearance(plan.path[i - 1], plan.path[i], disc(point, 0.0)));
  }
  return nearest_m;
}

}  // namespace

TEST_CASE("the radius grows with the distance from the goal, from d4 on and up to the cap") {
  const PlanningParams params = growing();
  const Vec2 start(0, 100);
  double last_m = 0.0;
  for (double distance_m = 0.3; distance_m < 9.0; distance_m += 0.1) {
    const double radius_m = grown_radius(disc({distance_m, 0}, kRadius_m), start, {0, 0}, params);
    CAPTURE(distance_m);
    CHECK(radius_m >= last_m);
    CHECK(radius_m <= kRadiusMax_m);
    if (distance_m <= params.growth_unchanged_within_m) CHECK(radius_m == kRadius_m);
    last_m = radius_m;
  }
  CHECK(last_m == kRadiusMax_m);
  CHECK(grown_radius(disc({3, 0}, kRadius_m), start, {0, 0}, params) ==
        Approx(kRadius_m + params.growth * (3.0 - params.growth_unchanged_within_m)));
  // A large obstacle stays, whatever the cap.
  CHECK(grown_radius(disc({8, 0}, 0.6), start, {0, 0}, params) == 0.6);
}

TEST_CASE("growth covers neither start nor goal, and what covers one does not grow") {
  std::mt19937_64 random(51);
  PlanningParams params = growing();
  params.growth = 1.0;
  params.growth_radius_max_m = 5.0;
  params.growth_unchanged_within_m = 0.0;
  int grown = 0;
  for (int i = 0; i < 3000; ++i) {
    const Obstacle obstacle = testing::random_obstacle(random, testing::test_bounds());
    const Vec2 start = testing::random_point(random, testing::test_bounds());
    const Vec2 goal = testing::random_point(random, testing::test_bounds());
    Obstacle larger = obstacle;
    larger.radius_m = grown_radius(obstacle, start, goal, params);
    REQUIRE(larger.radius_m >= obstacle.radius_m);
    for (const Vec2& end : {start, goal}) {
      REQUIRE(is_free(end, obstacle) == is_free(end, larger));
      if (!is_free(end, obstacle)) REQUIRE(larger == obstacle);
    }
    grown += larger.radius_m > obstacle.radius_m;
  }
  CHECK(grown > 2000);
}

TEST_CASE("robots grow, areas and walls do not") {
  const std::vector<Obstacle> obstacles{disc({0, 0}, kRadius_m), capsule({1, 0}, {1, 1}, kRadius_m),
                                        rounded_rectangle({-6, -1}, {-5, 1}, 0.1)};
  std::vector<Obstacle> out;
  grow(obstacles, 2, {5, 3}, {5, -3}, growing(), out);
  REQUIRE(out.size() == 3);
  CHECK(out[0].radius_m > kRadius_m);
  CHECK(out[1].radius_m > kRadius_m);
  CHECK(out[2] == obstacles[2]);
}

TEST_CASE("a team whose obstacles grow plans free paths that keep away from what is far from the goal") {
  std::mt19937_64 random(52);
  for (int i = 0; i < 30; ++i) {
    std::vector<Vec2> yellow, blue;
    for (int k = 0; k < 11; ++k) {
      yellow.push_back(testing::random_point(random, {{5.5, 4.0}}));
      blue.push_back(testing::random_point(random, {{5.5, 4.0}}));
    }
    const WorldState world = world_of(yellow, blue);
    const Targets targets = target_at(testing::random_point(random, {{5.5, 4.0}}));
    TeamPlanner plain(Team::yellow, {});
    TeamPlanner growing_team(Team::yellow, growing());
    const Plan without = plain.plan(division_a(), world, targets).plans.at(0).plan;
    const Plan with = growing_team.plan(division_a(), world, targets).plans.at(0).plan;
    CAPTURE(i);
    REQUIRE(with.status == without.status);
    if (with.status != PlanStatus::ok) continue;
    const TeamObstacles obstacles = obstacles_for(Team::yellow, division_a(), world, {});
    PlanRequest request;
    request.start = yellow[0];
    request.goal = targets.targets[0].pose.position_m;
    request.ignored = ignored_by(obstacles, {Team::yellow, 0}, false);
    CHECK(testing::fault_of(obstacles.field, request, with) == "");
    CHECK(with.length_m >= without.length_m - 1e-3 * without.length_m);
  }
  const WorldState world = world_of({{-4, 0}}, {{0, 0.05}});
  const Targets targets = target_at({4, 0});
  const double plain_m =
      nearest_pass_m(TeamPlanner(Team::yellow, {}).plan(division_a(), world, targets).plans.at(0).plan, {0, 0.05});
  const double wide_m = nearest_pass_m(
      TeamPlanner(Team::yellow, growing()).plan(division_a(), world, targets).plans.at(0).plan, {0, 0.05});
  CHECK(wide_m > plain_m + 0.1);
}

TEST_CASE("where growth closes the only gap the narrow way is taken") {
  std::vector<Vec2> wall;
  for (double y = -4.8; y < 4.9; y += 0.3) {
    if (std::abs(y) > 0.2) wall.push_back({-1, y});
  }
  wall.push_back({-1, 4.9});
  // A gap that lets a robot through, but no larger one.
  const WorldState world = world_of({{-4, 0}}, wall);
  const Targets targets = target_at({4, 0});
  const Plan plain = TeamPlanner(Team::yellow, {}).plan(division_a(), world, targets).plans.at(0).plan;
  REQUIRE(plain.status == PlanStatus::ok);
  CHECK(TeamPlanner(Team::yellow, growing()).plan(division_a(), world, targets).plans.at(0).plan == plain);
}

}  // namespace regista
