#include "planning/planners/apf_force.h"

namespace regista {
namespace {

/// Nearer than this an obstacle does not repel more strongly: touching is free, and 1/ρ has no value there.
constexpr double kNearest_m = 1e-3;

Vec2 nearest_on_core(const Vec2& point, const Obstacle& obstacle) {
  if (obstacle.core == Core::rectangle) return point.cwiseMax(obstacle.a).cwiseMin(obstacle.b);
  return nearest_on_segment(point, obstacle.a, obstacle.b);
}

}  // namespace

Vec2 potential_force(const ObstacleField& field, std::span<const std::size_t> ignored, const Vec2& goal,
                     const Vec2& point, const ApfParams& params) {
  const Vec2 to_goal = goal - point;
  const double goal_m = to_goal.norm();
  const double reach_m = params.influence_m;
  const double balance_m = std::min(params.balance_m, 0.9 * reach_m);
  const double gain = balance_m * balance_m / (1.0 / balance_m - 1.0 / reach_m);
  const double fading = std::min(1.0, (goal_m * goal_m) / (reach_m * reach_m));
  Vec2 force = to_goal.stableNormalized();
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (is_ignored(static_cast<ObstacleIndex>(i), ignored)) continue;
    const Obstacle& obstacle = field.obstacles()[i];
    const Vec2 away = point - nearest_on_core(point, obstacle);
    const double core_m = away.norm();
    if (core_m >= obstacle.radius_m + reach_m || core_m == 0.0) continue;
    const double distance_m = std::max(core_m - obstacle.radius_m, kNearest_m);
    const double strength = gain * (1.0 / distance_m - 1.0 / reach_m) / (distance_m * distance_m);
    force += away * (fading * strength / core_m);
  }
  return force;
}

}  // namespace regista
