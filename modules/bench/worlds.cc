#include "modules/bench/worlds.h"

#include <stdexcept>
#include <string>

#include "planning/obstacle_rules.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

constexpr std::uint16_t kTeamSize = 11;
constexpr double kBallKeepOut_m = 0.5;  ///< SSL rules, "Ball placement"

bool is_in_area(const Vec2& place, double side, const FieldGeometry& field) {
  return side * place.x() > field.length_m / 2 - field.defence_depth_m &&
         std::abs(place.y()) < field.defence_width_m / 2;
}

RobotState robot_at(Team team, std::size_t number, const Vec2& place) {
  RobotState robot;
  robot.id = {team, static_cast<std::uint16_t>(number)};
  robot.pose.position_m = place;
  return robot;
}

/// Robot 0 of each team is its keeper and stands in its area; yellow's is on -x.
WorldState random_world(std::mt19937_64& random, const FieldGeometry& field, double robot_radius_m) {
  const Bounds bounds{half_extent(field, robot_radius_m)};
  const auto in_an_area = [&field](const Vec2& p) { return is_in_area(p, -1.0, field) || is_in_area(p, 1.0, field); };
  const std::vector<Vec2> places =
      places_apart(random, bounds, std::size_t{2} * (kTeamSize - 1), 2.0 * robot_radius_m, in_an_area);
  // Two radii inside, away from those who stand at the line.
  const double apart_m = 2.0 * robot_radius_m;
  const auto keeper_place = [&](double side) {
    const double depth_m = uniform(random, 0.0, field.defence_depth_m - apart_m);
    return Vec2(side * (field.length_m / 2 - depth_m),
                uniform(random, -0.5, 0.5) * (field.defence_width_m - 2.0 * apart_m));
  };
  WorldState world;
  for (const Team team : {Team::yellow, Team::blue}) {
    const bool yellow = team == Team::yellow;
    world.robots.push_back(robot_at(team, 0, keeper_place(yellow ? -1.0 : 1.0)));
    for (std::size_t i = 1; i < kTeamSize; ++i) {
      world.robots.push_back(robot_at(team, i, places[i - 1 + (yellow ? 0U : kTeamSize - 1U)]));
    }
  }
  return world;
}

}  // namespace

Vec2 random_point(std::mt19937_64& random, const Bounds& bounds) {
  const Vec2& half = bounds.half_extent_m;
  const double x = uniform(random, -half.x(), half.x());
  return {x, uniform(random, -half.y(), half.y())};
}

std::vector<Vec2> places_apart(std::mt19937_64& random, const Bounds& bounds, std::size_t count, double apart_m,
                               const std::function<bool(const Vec2&)>& refused) {
  constexpr int kTries = 10000;  // per place; a field that can hold them needs a few
  std::vector<Vec2> places;
  const auto fits = [&](const Vec2& place) {
    if (refused && refused(place)) return false;
    return std::all_of(places.begin(), places.end(), [&](const Vec2& p) { return (p - place).norm() >= apart_m; });
  };
  while (places.size() < count) {
    Vec2 place = random_point(random, bounds);
    for (int i = 0; i < kTries && !fits(place); ++i) place = random_point(random, bounds);
    if (!fits(place)) throw std::runtime_error("no room for " + std::to_string(count) + " places");
    places.push_back(place);
  }
  return places;
}

TeamScene eleven_against_eleven_team(std::mt19937_64& random) {
  const PlanningParams params;
  const FieldGeometry field = division_a();
  const WorldState world = random_world(random, field, params.robot_radius_m);
  const TeamObstacles obstacles = obstacles_for(Team::yellow, field, world, params);
  TeamScene scene;
  scene.world.bounds = obstacles.field.bounds();
  scene.world.obstacles.assign(obstacles.field.obstacles().begin(), obstacles.field.obstacles().end());
  if (uniform(random) < 0.5) {
    const Bounds lines{Vec2(field.length_m, field.width_m) / 2};
    const Vec2 ball = random_point(random, lines);
    scene.world.obstacles.push_back(capsule(ball, random_point(random, lines), kBallKeepOut_m + params.robot_radius_m));
  }
  for (std::size_t i = 0; i < kTeamSize; ++i) {
    PlanRequest request;
    request.start = world.robots[i].pose.position_m;
    request.goal = random_point(random, scene.world.bounds);
    request.ignored = ignored_by(obstacles, world.robots[i].id, i == 0);
    request.seed = random();
    scene.requests.push_back(std::move(request));
  }
  return scene;
}

Scene eleven_against_eleven(std::mt19937_64& random) {
  TeamScene team = eleven_against_eleven_team(random);
  const std::size_t asking = random() % team.requests.size();
  return {std::move(team.world), std::move(team.requests[asking])};
}

TeamScene fleet(std::mt19937_64& random, std::size_t count, std::size_t asking) {
  const PlanningParams params;
  const double scale = std::sqrt(static_cast<double>(count) / (kRobotsPerSquareMetre * 12.0 * 9.0));
  TeamScene scene;
  scene.world.bounds.half_extent_m = scale * Vec2(6.0, 4.5);
  const double reach_m = 2.0 * params.robot_radius_m + params.team_margin_m;
  const std::vector<Vec2> places = places_apart(random, scene.world.bounds, count, reach_m);
  for (std::size_t i = 0; i < count; ++i) scene.world.obstacles.push_back(disc(places[i], reach_m));
  for (std::size_t i = 0; i < asking; ++i) {
    PlanRequest request;
    request.start = places[i];
    request.goal = random_point(random, scene.world.bounds);
    request.ignored = {i};
    request.seed = random();
    scene.requests.push_back(std::move(request));
  }
  return scene;
}

Scene crowd(std::mt19937_64& random, std::size_t count) {
  constexpr double kRadius_m = 0.21;
  Scene scene;
  scene.world.bounds.half_extent_m = {6.0, 4.5};
  for (std::size_t i = 0; i < count; ++i) {
    scene.world.obstacles.push_back(disc(random_point(random, scene.world.bounds), kRadius_m));
  }
  scene.request.start = random_point(random, scene.world.bounds);
  scene.request.goal = random_point(random, scene.world.bounds);
  scene.request.seed = random();
  return scene;
}

}  // namespace regista::bench
