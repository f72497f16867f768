// What is an obstacle to a team, from the state of the world and the rules of the game (SSL rules: "Defence area",
// "Robot shape", field setup), and which of these obstacles are none to one of its robots.
#pragma once

#include "planning/obstacle_field.h"
#include "planning/planning_params.h"
#include "world_model/types/field.h"
#include "world_model/types/world_state.h"

namespace regista {

/// A team's obstacles of one frame: robots first, in the order of the world, then areas and walls.
struct TeamObstacles {
  ObstacleField field;
  std::vector<RobotId> robots;  ///< obstacle i < robots.size() is this robot
  std::size_t own_area = 0;     ///< index of the team's own defence area
};

/// All robots as discs (both radii and the margin; capsules when stretched along their velocity), both defence areas
/// reaching back to the rear of the goals, the goals' walls, and the wall around the field as bounds. Throws
/// std::invalid_argument when a robot's position, velocity or turning rate or a measure of the field is not finite, or
/// the field has no room for a robot. Headings and the ball are not looked at.
TeamObstacles obstacles_for(Team team, const FieldGeometry& field, const WorldState& world,
                            const PlanningParams& params);

/// Sorted indices of what robot `id` ignores: itself, and its own area where it may enter.
std::vector<std::size_t> ignored_by(const TeamObstacles& obstacles, RobotId id, bool may_enter_own_area);

}  // namespace regista
