#include "modules/bench/paper/sbp_scenario.h"

#include <algorithm>
#include <stdexcept>

#include "planning/clearance.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

constexpr int kTries = 10000;  // per place; about one in two fits

Vec2 free_point(const World& world, const Vec2& x_m, std::mt19937_64& random) {
  for (int i = 0; i < kTries; ++i) {
    const double x = uniform(random, x_m[0], x_m[1]);
    const double half_m = world.bounds.half_extent_m.y();
    Vec2 point(x, uniform(random, -half_m, half_m));
    const auto is_clear = [&](const Obstacle& obstacle) { return is_free(point, obstacle); };
    if (std::all_of(world.obstacles.begin(), world.obstacles.end(), is_clear)) return point;
  }
  throw std::runtime_error("no free place in the region");
}

}  // namespace

SbpScenario sbp_scenario(const DataTable& data) {
  const DataTable table = data.table("scenario");
  SbpScenario scenario;
  scenario.bounds.half_extent_m = Vec2(table.number("length_m"), table.number("width_m")) / 2;
  scenario.robots = table.count("robots");
  scenario.robot_radius_m = table.number("robot_radius_m");
  scenario.agent_radius_m = table.number("agent_radius_m");
  scenario.start_x_m = table.point("start_x_m");
  scenario.robots_x_m = table.point("robots_x_m");
  scenario.goal_x_m = table.point("goal_x_m");
  return scenario;
}

Scene sbp_scene(const SbpScenario& scenario, std::mt19937_64& random) {
  Scene scene;
  scene.world.bounds = scenario.bounds;
  const auto outside_region = [&](const Vec2& place) {
    return place.x() < scenario.robots_x_m[0] || place.x() > scenario.robots_x_m[1];
  };
  const std::vector<Vec2> places =
      places_apart(random, scenario.bounds, scenario.robots, 2.0 * scenario.robot_radius_m, outside_region);
  for (const Vec2& place : places) {
    scene.world.obstacles.push_back(disc(place, scenario.robot_radius_m + scenario.agent_radius_m));
  }
  scene.request.start = free_point(scene.world, scenario.start_x_m, random);
  scene.request.goal = free_point(scene.world, scenario.goal_x_m, random);
  scene.request.seed = random();
  return scene;
}

double sbp_budget_us(const DataTable& data) {
  const DataTable budget = data.table("budget");
  return 1e6 / (budget.number("robots") * budget.number("camera_hz"));
}

std::size_t runs_or(std::size_t asked, const DataTable& figure) { return asked > 0 ? asked : figure.count("runs"); }

}  // namespace regista::bench
