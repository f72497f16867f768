// Other robots where they will be when they matter: at the moment of nearest approach to the robot that plans. A robot
// that crosses in front is gone by then, and two that come towards each other both see where they will meet.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "planning/obstacle.h"
#include "planning/planning_params.h"
#include "planning/route.h"
#include "planning/targets.h"
#include "world_model/types/world_state.h"

namespace regista {

/// Paths by robot number.
using TeamPaths = std::map<std::uint16_t, std::vector<Vec2>>;

class Prediction {
 public:
  /// Everybody's route in that world: team-mates with a target along `paths`, as far as those lead to it, else straight
  /// to it; all others straight on with their velocities for prediction_horizon_s. Values are finite.
  void look(Team team, const WorldState& world, const Targets& targets, const TeamPaths& paths,
            const PlanningParams& params);

  /// `out` becomes the obstacles as robot `self` of that world meets them on its way to the goal: obstacle
  /// i < world.robots.size() belongs to robot i and is moved to the nearest approach of both routes; then it shrinks as
  /// far as it would cover the robot itself, or the goal without having covered it unmoved.
  void predict(std::span<const Obstacle> obstacles, std::size_t self, const Vec2& goal,
               std::vector<Obstacle>& out) const;

 private:
  std::vector<Route> routes_;  ///< by robot of the world
  std::vector<Vec2> path_;
};

}  // namespace regista
