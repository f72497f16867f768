// Opponents that are about to hit each other: that changes where they go, and they do not know it yet.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "control/safety/opponent.h"

namespace regista {

/// An opponent's first touch with another one.
struct Touch {
  double at_s = std::numeric_limits<double>::infinity();  ///< infinite: none is foreseen
  Vec2 change_mps = Vec2::Zero();                         ///< of its velocity: equal masses that do not bounce
  bool operator==(const Touch&) const = default;
};

/// First touches within until_s of discs whose centres are bodies_m apart then, at constant velocities: `out` gets one
/// per opponent. That a partner may have been turned away by its own earlier touch is not followed.
void foresee_touches(std::span<const Opponent> opponents, double bodies_m, double until_s, std::vector<Touch>& out);

}  // namespace regista
