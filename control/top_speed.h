// How fast the robots of a team get, as far as they have shown it.
#pragma once

#include <limits>

#include "world_model/types/world_state.h"

namespace regista {

class TopSpeed {
 public:
  /// Looks at the robots of that team, dt_s > 0 after the last look.
  void update(const WorldState& world, Team team, double dt_s);

  /// The fastest that any of them has been seen driving, in m/s, at least 2; infinite in the first half second, when
  /// they may not have shown it yet. What is not seen again is forgotten by and by: it was a push, or a mistake of
  /// vision.
  double mps() const;

 private:
  double watched_s_ = 0.0;
  double fastest_mps_ = 0.0;
};

}  // namespace regista
