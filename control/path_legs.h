// A path as the robot has it before it: its legs from the one it is on, with the turns between them.
#pragma once

#include <span>
#include <vector>

#include "world_model/types/geometry.h"

namespace regista {

struct Leg {
  Vec2 from = Vec2::Zero();
  Vec2 direction = Vec2::UnitX();  ///< unit vector
  double length_m = 0.0;           ///< > 0
  double turn_rad = 0.0;           ///< from this leg into the next, positive to the left; 0 for the last
};

/// The leg of the path nearest to the position, from path[leg] to path[leg + 1]; of equally near ones the last. All
/// vertices before are passed. 0 for a path of one point; the path must have a point.
std::size_t nearest_leg(std::span<const Vec2> path, const Vec2& position_m);

/// The legs from the nearest one on; those too short to have a direction are left out. Empty where what remains of the
/// path is but a point.
std::vector<Leg> legs_ahead(std::span<const Vec2> path, const Vec2& position_m);

/// Along the leg from the position to the leg's end, metres; negative beyond it.
inline double distance_to_end(const Leg& leg, const Vec2& position_m) {
  return leg.length_m - (position_m - leg.from).dot(leg.direction);
}

}  // namespace regista
