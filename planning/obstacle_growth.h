// Robots that are kept away from the more, the farther they are from where one wants to go: "Variable object radius" of
// Costa & Tonidandel, figure 25. Far from the goal there is room for a wide way, and more time for things to move.
#pragma once

#include <span>
#include <vector>

#include "planning/obstacle.h"
#include "planning/planning_params.h"

namespace regista {

/// The radius of an obstacle to a robot on its way from start to goal: growth times the distance (of the core to the
/// goal, beyond growth_unchanged_within_m) larger, at most growth_radius_max_m, and never by more than half of the room
/// it leaves to start and goal, so that it covers neither. Never smaller than it is.
double grown_radius(const Obstacle& obstacle, const Vec2& start, const Vec2& goal, const PlanningParams& params);

/// `out` becomes the obstacles, the first `robots` of them grown.
void grow(std::span<const Obstacle> obstacles, std::size_t robots, const Vec2& start, const Vec2& goal,
          const PlanningParams& params, std::vector<Obstacle>& out);

}  // namespace regista
