// What robots whose commands are not known accelerate with: the change of their estimated velocities, smoothed.
#pragma once

#include <map>

#include "world_model/types/world_state.h"

namespace regista {

class AccelerationEstimate {
 public:
  /// Looks at the robots of that team, dt_s > 0 after the last look. filter_s >= 0 is the time constant of smoothing,
  /// largest_mps2 what a robot can do. Robots that are no longer there are forgotten.
  void update(const WorldState& world, Team team, double dt_s, double filter_s, double largest_mps2);

  /// m/s²; zero for a robot not seen twice.
  Vec2 of(RobotId id) const;

 private:
  struct Estimate {
    Vec2 velocity_mps = Vec2::Zero();
    Vec2 acceleration_mps2 = Vec2::Zero();
  };
  std::map<RobotId, Estimate> estimates_;
};

}  // namespace regista
