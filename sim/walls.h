// What stands still on the field: the boards around it and the goals' walls. Robots and ball are kept out of them.
#pragma once

#include <vector>

#include "world_model/types/field.h"

namespace regista {

struct Box {
  Vec2 low = Vec2::Zero();   ///< corner with the smaller coordinates
  Vec2 high = Vec2::Zero();  ///< opposite corner
  bool operator==(const Box&) const = default;
};

struct Walls {
  Vec2 half_extent_m = Vec2::Zero();  ///< of the floor inside the boards
  double goal_line_m = 0.0;           ///< |x| from which the goals' walls begin
  std::vector<Box> goals;
};

Walls walls_of(const FieldGeometry& field);

/// Moves a disc out of the walls it overlaps. Of its velocity into a wall, the part `restitution` (0–1) comes back.
void keep_off(const Walls& walls, double radius_m, double restitution, Vec2& position_m, Vec2& velocity_mps);

}  // namespace regista
