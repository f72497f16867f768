// The rules of the game as motion: where a team must not drive and how fast it may, in the present situation (SSL
// rules: "Stop", "Ball placement", "Kick-off", "Free kick"). Pure; obstacle_rules.h puts the shapes among the
// obstacles.
#pragma once

#include <vector>

#include "planning/game_situation.h"
#include "planning/obstacle.h"
#include "planning/rule_params.h"
#include "world_model/types/field.h"

namespace regista {

/// What no robot of the team may enter with its centre because of the situation: around the ball in stop and at kicks
/// of the other team, around the line from ball to place at a placement of the other team. Distances are between the
/// surfaces of robot and ball. Without a ball there is nothing to keep off, but for the place it shall go to.
std::vector<Obstacle> rule_obstacles(Team team, const WorldState& world, const Situation& situation,
                                     const RuleParams& params, double robot_radius_m);

/// How fast the team's robots may be, m/s: 0 at halt, infinite where no rule limits it.
double rule_speed_max(const Situation& situation, const RuleParams& params);

/// Least distance between a body and the opponent's defence area, metres: 0 where nothing but the area itself is
/// barred.
double rule_area_distance(const Situation& situation, const RuleParams& params);

}  // namespace regista
