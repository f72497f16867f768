// An opponent as the ways to avoid contact see it.
#pragma once

#include <limits>

#include "world_model/types/geometry.h"

namespace regista {

/// One whose mind is not known.
struct Opponent {
  Vec2 position_m = Vec2::Zero();
  Vec2 velocity_mps = Vec2::Zero();
  Vec2 acceleration_mps2 = Vec2::Zero();                           ///< estimated
  double speed_max_mps = std::numeric_limits<double>::infinity();  ///< what its team gets to; infinite: not known
};

}  // namespace regista
