// How a robot moves now, from what it was told and what vision says.
#pragma once

#include "control/control_params.h"
#include "world_model/types/geometry.h"

namespace regista {

/// The last command is what the robot does, delays aside, and carries no noise of vision, while the estimate would feed
/// its noise back. So it is the present motion wherever the estimate does not contradict it. A robot that was hit, is
/// held or was put elsewhere contradicts it: there the last command is drawn towards the estimate as far as is
/// plausible, which at the border of "plausible" is no jump. A robot seen first (`told` is nullptr) moves as estimated.
/// Field frame.
Twist present_motion(const Twist& estimated, const Twist* told, const ControlParams& params);

}  // namespace regista
