#include "control/safety/motion.h"

#include <algorithm>
#include <cmath>

namespace regista {
namespace {

/// A speed that is a whole number of periods' braking must not count as one more by rounding.
constexpr double kWholePeriods = 1e-6;

/// Until so accelerated motion has that speed; 0 where it is faster already and gets no slower. The acceleration is not
/// zero.
double until_speed_s(const Vec2& velocity_mps, const Vec2& acceleration_mps2, double speed_mps) {
  const double a = acceleration_mps2.squaredNorm();
  const double b = acceleration_mps2.dot(velocity_mps);
  const double c = velocity_mps.squaredNorm() - speed_mps * speed_mps;
  return std::max(0.0, (-b + std::sqrt(std::max(0.0, b * b - a * c))) / a);
}

void append_braking(Motion& motion, const Vec2& velocity_mps, double braking_mps2, double period_s) {
  const double speed = velocity_mps.norm();
  if (speed == 0.0) return;
  const double periods = std::max(1.0, std::ceil(speed / (braking_mps2 * period_s) - kWholePeriods));
  const double duration_s = periods * period_s;
  motion.then_stand(-velocity_mps / duration_s, duration_s);
}

}  // namespace

void Motion::then(const Vec2& acceleration_mps2, double duration_s) {
  Phase& last = phases_[count_ - 1];
  last.acceleration_mps2 = acceleration_mps2;
  Phase& next = phases_[count_++];
  next.begin_s = last.begin_s + duration_s;
  next.position_m = position_after(last, duration_s);
  next.velocity_mps = velocity_after(last, duration_s);
  next.acceleration_mps2 = Vec2::Zero();
  // The curve is a parabola, which lies within the triangle of its ends and the crossing of its end tangents.
  const Vec2 between = last.position_m + (duration_s / 2.0) * last.velocity_mps;
  low_m_ = low_m_.cwiseMin(between).cwiseMin(next.position_m);
  high_m_ = high_m_.cwiseMax(between).cwiseMax(next.position_m);
}

void Motion::then_stand(const Vec2& acceleration_mps2, double duration_s) {
  then(acceleration_mps2, duration_s);
  phases_[count_ - 1].velocity_mps = Vec2::Zero();
}

Motion braking(const Vec2& position_m, const Vec2& velocity_mps, double hold_s, double braking_mps2, double period_s) {
  Motion motion(position_m, velocity_mps);
  if (hold_s > 0.0 && !velocity_mps.isZero(0.0)) motion.then(Vec2::Zero(), hold_s);
  append_braking(motion, velocity_mps, braking_mps2, period_s);
  return motion;
}

Motion manoeuvre(const Vec2& position_m, const Vec2& velocity_mps, const Vec2& next_velocity_mps, double hold_s,
                 double braking_mps2, double period_s) {
  Motion motion(position_m, velocity_mps);
  motion.then((next_velocity_mps - velocity_mps) / period_s, period_s);
  if (hold_s > 0.0 && !next_velocity_mps.isZero(0.0)) motion.then(Vec2::Zero(), hold_s);
  append_braking(motion, next_velocity_mps, braking_mps2, period_s);
  return motion;
}

Motion sustained(const Vec2& position_m, const Vec2& velocity_mps, const Vec2& acceleration_mps2, double hold_s,
                 double speed_max_mps, double period_s, double coast_s) {
  Motion motion(position_m, velocity_mps);
  if (!acceleration_mps2.isZero(0.0)) {
    const double limit_s = until_speed_s(velocity_mps, acceleration_mps2, speed_max_mps);
    motion.then(acceleration_mps2, std::max(period_s, std::min(hold_s, limit_s)));
  }
  motion.then(Vec2::Zero(), coast_s);
  return motion;
}

}  // namespace regista
