// What an opponent is expected to do, by how it has been driving: nobody tells us what it is told.
#pragma once

#include "control/safety/motion.h"
#include "control/safety/opponent.h"
#include "control/safety/opponent_touches.h"
#include "control/safety/safety_params.h"

namespace regista {

/// From now to the horizon. An opponent that brakes does until it stands. One that speeds up straight ahead does until
/// it is as fast as its team gets, for speeding_up_lasts_s at most. In a turn, or where its team's top speed is not
/// known or just proved wrong, an acceleration lasts for acceleration_lasts_s at any speed; then it drives on. Who hits
/// another one before (its first touch) goes on with it: what it wanted tells nothing any more.
Motion expected_motion(const Opponent& opponent, const Touch& touch, const SafetyParams& params);

}  // namespace regista
