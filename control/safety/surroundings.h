// What does not move around a team's robots, as their safety search sees it.
#pragma once

#include <vector>

#include "planning/game_situation.h"
#include "planning/obstacle.h"
#include "world_model/types/field.h"
#include "world_model/types/world_state.h"

namespace regista {

struct Surroundings {
  Vec2 half_extent_m = Vec2::Constant(kLargest_m);  ///< where centres may be: |x|, |y| up to it
  std::vector<Obstacle> shapes;                     ///< grown by a robot's radius
  std::size_t own_area = SIZE_MAX;  ///< index of the team's defence area, which its goalkeeper may enter
  bool operator==(const Surroundings&) const = default;
};

/// The boards around the field, goals' walls, defence areas and what the rules keep robots out of in that situation:
/// the same shapes as planning's with less margin, what must not happen and not what is better avoided. Throws as
/// static_obstacles does.
Surroundings surroundings_of(Team team, const FieldGeometry& field, const WorldState& world, const Situation& situation,
                             double robot_radius_m);

}  // namespace regista
