// Opponents at the moment that our next commands are planned for: what their commands are nobody tells, but what they
// accelerate with shows, and until then goes on.
#pragma once

#include <span>
#include <vector>

#include "control/acceleration_estimate.h"
#include "control/control_params.h"
#include "control/safety/opponent.h"
#include "world_model/types/world_state.h"

namespace regista {

/// From the capture of what the state is made of to the moment that our motion is planned for, seconds, >= 0: until
/// commands act, and the lag of our drives.
double planning_delay_s(const WorldState& world, double drive_lag_s);

/// Where an opponent is delay_s >= 0 later than what its velocity was estimated from, given its position if it were to
/// coast until then: its acceleration lasts so long, or, if it brakes, until it stands.
Opponent accelerated(const Vec2& coasting_m, const Vec2& velocity_mps, const Vec2& acceleration_mps2, double delay_s);

class PresentOpponents {
 public:
  /// Those of `team` in the world state, in its order; dt_s > 0 after the last one. Good until the next call.
  std::span<const Opponent> update(const WorldState& world, Team team, const ControlParams& params, double dt_s);

 private:
  AccelerationEstimate accelerations_;
  std::vector<Opponent> opponents_;
};

}  // namespace regista
