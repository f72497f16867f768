#include "control/present_motion.h"

#include <algorithm>
#include <cmath>

namespace regista {

Twist present_motion(const Twist& estimated, const Twist* told, const ControlParams& params) {
  const double speed_max = params.limits.speed_max_mps;
  const double rate_max = params.limits.angular_speed_max_radps;
  if (told == nullptr) {
    return {clamped_norm(estimated.velocity_mps, speed_max), std::clamp(estimated.angular_radps, -rate_max, rate_max)};
  }
  const Vec2 error = told->velocity_mps - estimated.velocity_mps;
  const double rate_error = told->angular_radps - estimated.angular_radps;
  const double rate_error_max = params.plausible_angular_error_radps;
  // Drawing must not make a command faster than the robot may be; one that is because its limit was lowered slows down.
  const double speed_cap = std::max(speed_max, told->velocity_mps.norm());
  const double rate_cap = std::max(rate_max, std::abs(told->angular_radps));
  Twist motion = *told;
  if (error.norm() > params.plausible_speed_error_mps) {
    motion.velocity_mps =
        clamped_norm(estimated.velocity_mps + clamped_norm(error, params.plausible_speed_error_mps), speed_cap);
  }
  if (std::abs(rate_error) > rate_error_max) {
    const double drawn = estimated.angular_radps + std::clamp(rate_error, -rate_error_max, rate_error_max);
    motion.angular_radps = std::clamp(drawn, -rate_cap, rate_cap);
  }
  return motion;
}

}  // namespace regista
