#include "control/heading_controller.h"

#include <algorithm>
#include <cmath>

#include "control/motion_limits.h"
#include "control/speed_profile.h"

namespace regista {

double wanted_rate(double heading_rad, double rate_radps, double target_rad, const RobotLimits& limits,
                   const HeadingParams& params, double dt_s) {
  const double braking = params.braking_share * limits.angular_acceleration_max_radps2;
  // The nearer way round is measured from where the robot could come to rest, so that noise around half a turn does not
  // reverse a turn under way.
  const double stopping = rate_radps * std::abs(rate_radps) / (2.0 * braking);
  const double error = wrap_angle(target_rad - heading_rad - stopping) + stopping;
  const double distance = std::max(0.0, std::abs(error) - params.settle_angle_rad);
  const double rate =
      std::min(limits.angular_speed_max_radps, approach_speed(distance, braking, params.settle_time_s, dt_s));
  return limited_rate(rate_radps, std::copysign(rate, error), limits, dt_s);
}

}  // namespace regista
