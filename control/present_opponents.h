// Opponents at the moment that our next commands are planned for: what they are told nobody tells us, but what they
// accelerate with shows, and goes on until then.
#pragma once

#include <span>
#include <vector>

#include "control/acceleration_estimate.h"
#include "control/control_params.h"
#include "control/safety/opponent.h"
#include "control/top_speed.h"
#include "world_model/types/world_state.h"

namespace regista {

/// A longer delay counts as this one, seconds: nothing is known of opponents so far ahead.
inline constexpr double kLongestDelay_s = 0.3;

/// From the capture of what the state is made of to the moment that our motion is planned for, seconds, in [0,
/// kLongestDelay_s]: until commands act, and on for the lag of our drives.
double planning_delay_s(const WorldState& world, double drive_lag_s);

/// Where an opponent is delay_s >= 0 after its velocity was estimated, given where it would have coasted to by then.
/// Its acceleration goes on for lasts_s in [0, delay_s]; who brakes meanwhile to a stop stays there.
Opponent accelerated(const Vec2& coasted_to_m, const Vec2& velocity_mps, const Vec2& acceleration_mps2, double delay_s,
                     double lasts_s);

class PresentOpponents {
 public:
  /// The robots of `theirs` in the world state, in its order; dt_s > 0 after the last one. Good until the next call.
  std::span<const Opponent> update(const WorldState& world, Team theirs, const ControlParams& params, double dt_s);

 private:
  AccelerationEstimate accelerations_;
  TopSpeed top_speed_;
  std::vector<Opponent> opponents_;
};

}  // namespace regista
