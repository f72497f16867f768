#include "planning/predicted_obstacles.h"

#include <algorithm>
#include <cmath>

#include "planning/clearance.h"

namespace regista {
namespace {

/// A path that ends nearer than this to the target still leads there: goals that are moved off others tremble.
constexpr double kSameGoal_m = 0.3;

/// Smaller by what the point is covered; a core that holds it cannot be helped.
double uncovering_radius(const Obstacle& obstacle, const Vec2& point) {
  return std::max(0.0, obstacle.radius_m + std::min(0.0, clearance(point, obstacle)));
}

const Target* target_of(const Targets& targets, std::uint16_t robot) {
  const auto found = std::find_if(targets.targets.begin(), targets.targets.end(),
                                  [&](const Target& target) { return target.robot == robot; });
  return found != targets.targets.end() ? &*found : nullptr;
}

}  // namespace

void Prediction::look(Team team, const WorldState& world, const Targets& targets, const TeamPaths& paths,
                      const PlanningParams& params) {
  const auto steps = static_cast<std::size_t>(std::ceil(params.route_horizon_s / kRouteStep_s));
  routes_.resize(world.robots.size());
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    const RobotState& robot = world.robots[i];
    const Target* target = robot.id.team == team ? target_of(targets, robot.id.number) : nullptr;
    if (target == nullptr || !is_finite(target->pose.position_m)) {
      drift(robot.pose.position_m, robot.twist.velocity_mps, params.prediction_horizon_s, steps, routes_[i]);
      continue;
    }
    path_ = {robot.pose.position_m, target->pose.position_m};
    const auto known = paths.find(robot.id.number);
    if (known != paths.end() && (known->second.back() - target->pose.position_m).norm() < kSameGoal_m) {
      path_ = known->second;
      path_.front() = robot.pose.position_m;
    }
    follow(path_, robot.twist.velocity_mps, target->speed_max_mps, steps, routes_[i]);
  }
}

void Prediction::predict(std::span<const Obstacle> obstacles, std::size_t self, const Vec2& goal,
                         std::vector<Obstacle>& out) const {
  out.assign(obstacles.begin(), obstacles.end());
  const Vec2& start = routes_[self].front();
  for (std::size_t i = 0; i < routes_.size(); ++i) {
    if (i == self) continue;
    const bool goal_was_covered = clearance(goal, out[i]) < 0.0;
    const Vec2 way = way_to_nearest_approach(routes_[self], routes_[i]);
    out[i].a += way;
    out[i].b += way;
    out[i].radius_m = uncovering_radius(out[i], start);
    if (!goal_was_covered) out[i].radius_m = uncovering_radius(out[i], goal);
  }
}

}  // namespace regista
