// Where robots stand at the beginning: both teams on their own halves, mirror images of each other.
#pragma once

#include <vector>

#include "world_model/types/field_side.h"

namespace regista {

struct RobotPlacement {
  RobotId id;
  Pose pose;
  bool operator==(const RobotPlacement&) const = default;
};

/// Number 0 in the middle of its own defence area, the others in a square grid between the centre line and the own goal
/// line, outside that area, spaced as widely as fits (at most 2 m); all look at the opponent's goal. Sorted by id.
/// Throws std::invalid_argument when that many robots do not fit; says how many would.
std::vector<RobotPlacement> formation(const FieldGeometry& field, int robots_per_team, double radius_m);

}  // namespace regista
