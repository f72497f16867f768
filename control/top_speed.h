// How fast the robots of a team get, as far as they have shown it.
#pragma once

#include "control/acceleration_estimate.h"
#include "world_model/types/world_state.h"

namespace regista {

class TopSpeed {
 public:
  /// Looks at the robots of that team, whose accelerations are as estimated, dt_s > 0 after the last look.
  void update(const WorldState& world, Team team, const AccelerationEstimate& accelerations, double dt_s);

  /// The fastest that any of them has been seen driving while it sped up no more, in m/s; infinite until one has driven
  /// fast so for half a second. What is not seen again while they do is forgotten by and by: it was a push, or a
  /// mistake of vision.
  double mps() const;

 private:
  double watched_s_ = 0.0;  ///< while one drove fast
  double fastest_mps_ = 0.0;
};

}  // namespace regista
