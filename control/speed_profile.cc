#include "control/speed_profile.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace regista {

double speed_before(double distance, double end_speed, double braking) {
  return std::sqrt(end_speed * end_speed + 2.0 * braking * distance);
}

double trapezoid_duration(double distance, double start_speed, double end_speed, double speed_max, double acceleration,
                          double braking) {
  // Where speeding up meets slowing down: peak² − start² = 2·a·d1, peak² − end² = 2·b·d2, d1 + d2 = distance.
  const double peak_squared = (2.0 * acceleration * braking * distance + braking * start_speed * start_speed +
                               acceleration * end_speed * end_speed) /
                              (acceleration + braking);
  const double peak = std::min(std::sqrt(peak_squared), speed_max);
  const double rounding = 1e-9 * (1.0 + speed_max);  // speeds that meet exactly must not fail by the last bit
  if (!(acceleration > 0.0 && braking > 0.0 && distance >= 0.0 && start_speed >= 0.0 && end_speed >= 0.0 &&
        start_speed <= peak + rounding && end_speed <= peak + rounding)) {
    throw std::invalid_argument("trapezoid_duration: no trapezoid over " + std::to_string(distance) + " from " +
                                std::to_string(start_speed) + " to " + std::to_string(end_speed) + " below " +
                                std::to_string(speed_max) + " with " + std::to_string(acceleration) + " up and " +
                                std::to_string(braking) + " down");
  }
  const double up = (peak * peak - start_speed * start_speed) / (2.0 * acceleration);
  const double down = (peak * peak - end_speed * end_speed) / (2.0 * braking);
  const double cruise = std::max(0.0, distance - up - down);
  return (peak - start_speed) / acceleration + (peak - end_speed) / braking + (cruise > 0.0 ? cruise / peak : 0.0);
}

double approach_speed(double distance, double braking, double settle_time_s, double dt_s) {
  // Exponential part: v = d/τ decelerates by v/τ, which reaches `braking` at v = braking·τ, d = braking·τ². A settle
  // time below one period would overshoot.
  const double settle_s = std::max(settle_time_s, dt_s);
  const double joint = braking * settle_s * settle_s;
  if (distance <= joint) return distance / settle_s;
  // Speeds v, v − braking·dt, … held for dt each cover v²/(2·braking) + v·dt/2. Solved for v, with the distance
  // shifted so that both parts give the same speed at the joint.
  const double half_step = braking * dt_s / 2.0;
  const double shift = joint / 2.0 - settle_s * half_step;
  return std::sqrt(half_step * half_step + 2.0 * braking * (distance - shift)) - half_step;
}

}  // namespace regista
