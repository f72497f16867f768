// What does not move around a team's robots, as their safety search sees it.
#pragma once

#include <vector>

#include "planning/obstacle.h"
#include "world_model/types/field.h"

namespace regista {

struct Surroundings {
  Vec2 half_extent_m = Vec2::Constant(kLargest_m);  ///< where centres may be: |x|, |y| up to it
  std::vector<Obstacle> shapes;                     ///< grown by a robot's radius
  std::size_t own_area = SIZE_MAX;                  ///< index of the team's defence area, which its goalkeeper may enter
  bool operator==(const Surroundings&) const = default;
};

/// The boards around the field, for robots of that radius.
inline Surroundings surroundings_of(const FieldGeometry& field, double radius_m) {
  return {half_extent(field, radius_m), {}};
}

}  // namespace regista
