#include "modules/bench/motion/shuttle.h"

#include <algorithm>
#include <cmath>

namespace regista::bench {

Shuttle::Shuttle(const Vec2& a, const Vec2& b, const RobotLimits& limits)
    : from_m_(a),
      way_((b - a).stableNormalized()),
      distance_m_((b - a).norm()),
      acceleration_mps2_(limits.acceleration_max_mps2),
      braking_mps2_(limits.braking_max_mps2) {
  const double per_speed2 = 0.5 / acceleration_mps2_ + 0.5 / braking_mps2_;  // metres, of speeding up and braking
  top_mps_ = std::min(limits.speed_max_mps, std::sqrt(distance_m_ / per_speed2));
  cruise_s_ = top_mps_ > 0.0 ? std::max(0.0, distance_m_ / top_mps_ - top_mps_ * per_speed2) : 0.0;
}

Vec2 Shuttle::place(double phase, double time_s) const {
  const double there_s = top_mps_ / acceleration_mps2_ + cruise_s_ + top_mps_ / braking_mps2_;
  if (there_s == 0.0) return from_m_;
  const double turns = phase + time_s / (2.0 * there_s);
  const double share = 2.0 * (turns - std::floor(turns));
  const double driven = share < 1.0 ? driven_m(share * there_s) : distance_m_ - driven_m((share - 1.0) * there_s);
  return from_m_ + driven * way_;
}

double Shuttle::driven_m(double time_s) const {
  const double up_s = std::min(time_s, top_mps_ / acceleration_mps2_);
  const double cruise_s = std::clamp(time_s - up_s, 0.0, cruise_s_);
  const double down_s = time_s - up_s - cruise_s;
  return 0.5 * acceleration_mps2_ * up_s * up_s + top_mps_ * cruise_s +
         (top_mps_ - 0.5 * braking_mps2_ * down_s) * down_s;
}

}  // namespace regista::bench
