// How requests spell robots and poses: "Y3", and "x_m y_m" or "x_m y_m heading_rad".
#pragma once

#include <string>

#include "world_model/types/geometry.h"
#include "world_model/types/robot_id.h"

namespace regista {

/// Both throw RequestRefused with one line that shows the right form.
RobotId parse_robot(const std::string& text);
Pose parse_pose(const std::string& text);

}  // namespace regista
