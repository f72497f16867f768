// The velocities that the safety search tries.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "control/safety/safety_robot.h"
#include "world_model/types/robot_limits.h"

namespace regista {

/// A velocity and its squared distance from the wanted one.
using VelocitySample = std::pair<double, Vec2>;

/// `out` becomes the wanted velocity; then, nearest to it first, standing, driving on, and three magnitudes of
/// acceleration in each of so many directions. All as far as they can be reached within period_s.
void sample_velocities(const SafetyRobot& robot, const RobotLimits& limits, std::int64_t directions, double period_s,
                       std::vector<VelocitySample>& out);

}  // namespace regista
