// What a robot's velocity may become within one period: the last stage of every command, whoever wanted it.
#pragma once

#include "world_model/types/geometry.h"
#include "world_model/types/robot_limits.h"

namespace regista {

/// `wanted`, or the furthest velocity on the straight way from `present` to it that dt_s allows. The change may lie,
/// seen along the present velocity, in a half disc of radius acceleration·dt ahead and in a half ellipse behind, with
/// half axes braking·dt along and acceleration·dt across. Never faster than the faster of the two, nor by more than
/// acceleration·dt faster than the present.
Vec2 limited_velocity(const Vec2& present_mps, const Vec2& wanted_mps, const RobotLimits& limits, double dt_s);

/// Likewise for the turning rate, with the angular acceleration both ways.
double limited_rate(double present_radps, double wanted_radps, const RobotLimits& limits, double dt_s);

}  // namespace regista
