// A robot of ours as the ways to avoid contact see it.
#pragma once

#include "world_model/types/geometry.h"

namespace regista {

/// As its commands move it: the velocity it has been told, and where that begins to act.
struct SafetyRobot {
  Vec2 position_m = Vec2::Zero();
  Vec2 velocity_mps = Vec2::Zero();
  Vec2 wanted_mps = Vec2::Zero();  ///< velocity after this period, need not be reachable
  double speed_max_mps = 3.0;
  bool may_enter_own_area = false;
  bool must_stand = false;  ///< brakes and then stands, whoever comes: halted, or nobody plans for it
};

}  // namespace regista
