// Other robots where they will be when they matter: at the moment of nearest approach to the robot that plans. A robot
// that crosses in front is gone by then, and two that come towards each other both see where they will meet.
#pragma once

#include <span>
#include <vector>

#include "planning/obstacle.h"
#include "world_model/types/world_state.h"

namespace regista {

/// Seconds until two points that keep their velocities are nearest, in [0, horizon_s]; 0 for no relative motion.
double nearest_approach_s(const RobotState& a, const RobotState& b, double horizon_s);

/// How far ahead others are expected, and how the robot itself.
struct Prediction {
  double horizon_s = 0.0;       ///< of opponents
  double team_horizon_s = 0.0;  ///< of team-mates
  double speed_mps = 0.0;       ///< at which the robot itself is expected to drive straight to its goal, and stop there
  bool operator==(const Prediction&) const = default;
};

/// `out` becomes the obstacles as robot `self` meets them: obstacle i < world.robots.size() belongs to robot i and is
/// moved along its velocity to the nearest approach, at most so far ahead as the prediction reaches; then it shrinks as
/// far as it would cover the start, or the goal without having covered it unmoved. Values are finite, all numbers of
/// the prediction >= 0.
void predict(std::span<const Obstacle> obstacles, const WorldState& world, const RobotState& self, const Vec2& goal,
             const Prediction& prediction, std::vector<Obstacle>& out);

}  // namespace regista
