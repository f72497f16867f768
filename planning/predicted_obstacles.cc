#include "planning/predicted_obstacles.h"

#include "planning/clearance.h"

namespace regista {
namespace {

/// Smaller by what the point is covered; a core that holds it cannot be helped.
double uncovering_radius(const Obstacle& obstacle, const Vec2& point) {
  return std::max(0.0, obstacle.radius_m + std::min(0.0, clearance(point, obstacle)));
}

}  // namespace

double nearest_approach_s(const RobotState& a, const RobotState& b, double horizon_s) {
  const Vec2 apart = b.pose.position_m - a.pose.position_m;
  const Vec2 velocity = b.twist.velocity_mps - a.twist.velocity_mps;
  const double speed2 = velocity.squaredNorm();
  return speed2 > 0.0 ? std::clamp(-apart.dot(velocity) / speed2, 0.0, horizon_s) : 0.0;
}

void predict(std::span<const Obstacle> obstacles, const WorldState& world, const RobotState& self, const Vec2& goal,
             const Prediction& prediction, std::vector<Obstacle>& out) {
  out.assign(obstacles.begin(), obstacles.end());
  // Of a robot that turns or sets out, the present velocity tells little about where it will be.
  RobotState on_its_way = self;
  const Vec2 way = goal - self.pose.position_m;
  const bool moves = prediction.speed_mps > 0.0 && !way.isZero(0.0);
  on_its_way.twist.velocity_mps = moves ? Vec2(prediction.speed_mps * way.normalized()) : Vec2(Vec2::Zero());
  const double arrival_s = moves ? way.norm() / prediction.speed_mps : 0.0;
  RobotState there = self;
  if (moves) there.pose.position_m = goal;
  there.twist.velocity_mps = Vec2::Zero();
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    const RobotState& other = world.robots[i];
    if (other.id == self.id) continue;
    const bool goal_was_covered = clearance(goal, out[i]) < 0.0;
    const double ahead_s = other.id.team == self.id.team ? prediction.team_horizon_s : prediction.horizon_s;
    const double under_way_s = nearest_approach_s(on_its_way, other, std::min(arrival_s, ahead_s));
    const double approach_s =
        under_way_s < arrival_s ? under_way_s : std::max(under_way_s, nearest_approach_s(there, other, ahead_s));
    const Vec2 ahead = approach_s * other.twist.velocity_mps;
    out[i].a += ahead;
    out[i].b += ahead;
    out[i].radius_m = uncovering_radius(out[i], self.pose.position_m);
    if (!goal_was_covered) out[i].radius_m = uncovering_radius(out[i], goal);
  }
}

}  // namespace regista
