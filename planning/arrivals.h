// When the robots of a team will stand at their targets: how long their team-mates expect them to keep moving.
#pragma once

#include <vector>

#include "planning/targets.h"
#include "world_model/types/world_state.h"

namespace regista {

/// `arrivals_s` gets one for each robot of the world, seconds from now: at the speed it has or a moderate one within
/// its target's limit and speed_max_mps. Infinite for those without target or that may not move.
void find_arrivals(const WorldState& world, const Targets& targets, double speed_max_mps,
                   std::vector<double>& arrivals_s);

}  // namespace regista
