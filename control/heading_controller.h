// Where a robot looks while it drives: its own trapezoidal profile in the angle, independent of the path.
#pragma once

#include "control/control_params.h"

namespace regista {

/// The turning rate, rad/s, that a robot at heading_rad which turns with rate_radps shall have during the next dt_s so
/// that it comes to look at target_rad without passing it. Within the angular limits as far as rate_radps is.
double wanted_rate(double heading_rad, double rate_radps, double target_rad, const RobotLimits& limits,
                   const HeadingParams& params, double dt_s);

}  // namespace regista
