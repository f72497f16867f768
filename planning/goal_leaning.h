// A goal that another robot stands on: the robot that waits for it waits on its own side.
#pragma once

#include <span>

#include "planning/obstacle.h"
#include "planning/request.h"

namespace regista {

/// Moves a goal that a disc covers, unless the request ignores that one, a little towards the start.
void lean(PlanRequest& request, std::span<const Obstacle> obstacles);

}  // namespace regista
