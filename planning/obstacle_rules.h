// What is an obstacle to a team, from the state of the world and the rules of the game (SSL rules: "Defence area",
// "Robot shape", field setup), and which of these obstacles are none to one of its robots.
#pragma once

#include "planning/game_situation.h"
#include "planning/obstacle_field.h"
#include "planning/planning_params.h"
#include "world_model/types/field.h"
#include "world_model/types/world_state.h"

namespace regista {

/// A team's obstacles of one frame: robots first, in the order of the world, then the static ones.
struct TeamObstacles {
  ObstacleField field;
  std::vector<RobotId> robots;  ///< obstacle i < robots.size() is this robot
  std::size_t own_area = 0;     ///< index of the team's own defence area
};

/// Index of the team's own defence area among its static obstacles.
inline constexpr std::size_t kOwnArea = 0;

/// What is forbidden to a team whoever stands where: both defence areas reaching back to the rear of the goals (own one
/// first, the opponent's grown by the distance the situation demands), the goals' walls, and the shapes the rules
/// forbid in this situation. Of the world only the ball is looked at; throws std::invalid_argument when it is not
/// finite.
std::vector<Obstacle> static_obstacles(Team team, const FieldGeometry& field, const WorldState& world,
                                       const Situation& situation, const PlanningParams& params);

/// All robots as discs (both radii and the margin; capsules when stretched along their velocity), the static obstacles,
/// and the wall around the field as bounds. Throws std::invalid_argument when a robot's position, velocity or turning
/// rate, the place of a ball that the rules keep robots off, or a measure of the field is not finite, or the field has
/// no room for a robot. Headings are not looked at.
TeamObstacles obstacles_for(Team team, const FieldGeometry& field, const WorldState& world,
                            const PlanningParams& params, const Situation& situation = {});

/// Sorted indices of what robot `id` ignores: itself, and its own area where it may enter.
std::vector<std::size_t> ignored_by(const TeamObstacles& obstacles, RobotId id, bool may_enter_own_area);

}  // namespace regista
