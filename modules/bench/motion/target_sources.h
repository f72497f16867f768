// Where a team's targets come from in a closed loop. What is referred to must outlive the loop.
#pragma once

#include "modules/bench/motion/closed_loop.h"
#include "sim/random_targets.h"

namespace regista::bench {

/// Always the same.
inline TargetSource source_of(const Targets& targets) {
  return [&targets](const WorldState& /*world*/) -> const Targets& { return targets; };
}

/// A new random one for whoever has arrived.
inline TargetSource source_of(RandomTargets& targets) {
  return [&targets](const WorldState& world) -> const Targets& { return targets.update(world); };
}

}  // namespace regista::bench
