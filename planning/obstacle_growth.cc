#include "planning/obstacle_growth.h"

#include "planning/clearance.h"

namespace regista {
namespace {

/// Touching two grown obstacles on either side is as bad as being covered, so they leave some room.
constexpr double kShareOfRoom = 0.5;

}  // namespace

double grown_radius(const Obstacle& obstacle, const Vec2& start, const Vec2& goal, const PlanningParams& params) {
  const double to_goal_m = clearance(goal, obstacle);
  const double room_m = std::min(to_goal_m, clearance(start, obstacle));
  const double far_m = to_goal_m + obstacle.radius_m - params.growth_unchanged_within_m;
  const double wanted_m = std::min(obstacle.radius_m + params.growth * far_m, params.growth_radius_max_m);
  // A comparison with what is not a number leaves the radius as it is; the planner says what is wrong with the ends.
  const double radius_m = std::min(wanted_m, obstacle.radius_m + kShareOfRoom * room_m);
  return radius_m > obstacle.radius_m ? radius_m : obstacle.radius_m;
}

void grow(std::span<const Obstacle> obstacles, std::size_t robots, const Vec2& start, const Vec2& goal,
          const PlanningParams& params, std::vector<Obstacle>& out) {
  out.assign(obstacles.begin(), obstacles.end());
  for (std::size_t i = 0; i < robots; ++i) out[i].radius_m = grown_radius(out[i], start, goal, params);
}

}  // namespace regista
