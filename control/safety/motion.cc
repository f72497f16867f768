#include "control/safety/motion.h"

#include <algorithm>
#include <cmath>

namespace regista {
namespace {

/// A speed that is a whole number of periods' braking must not count as one more by rounding.
constexpr double kWholePeriods = 1e-6;

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

const Phase& Motion::phase_at(double at_s) const {
  std::size_t i = 0;
  while (i + 1 < count_ && phases_[i + 1].begin_s <= at_s) ++i;
  return phases_[i];
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
    const double duration_s = std::max(period_s, hold_s);
    // Speeds up to the limit are a disc: what lies between two of its velocities lies in it.
    const Vec2 then_mps =
        clamped_norm(velocity_mps + duration_s * acceleration_mps2, std::max(speed_max_mps, velocity_mps.norm()));
    motion.then((then_mps - velocity_mps) / duration_s, duration_s);
  }
  motion.then(Vec2::Zero(), coast_s);
  return motion;
}

}  // namespace regista
