#include "world_model/ball_filter.h"

#include <algorithm>
#include <cmath>

#include "world_model/prediction.h"

namespace regista {
namespace {

AxisFilter start(double value, const BallFilterParams& params) {
  return {value, 0.0, params.position_sigma_m * params.position_sigma_m, 0.0,
          params.speed_sigma_mps * params.speed_sigma_mps};
}

/// A change of velocity of that variance at a moment evenly distributed over the last t: what it makes of position and
/// velocity now. E[s] = t/2 and E[s²] = t²/3 for the time s since the change.
void add_kick(AxisFilter& axis, double t, double speed_variance) {
  axis.variance += speed_variance * t * t / 3.0;
  axis.covariance += speed_variance * t / 2.0;
  axis.rate_variance += speed_variance;
}

}  // namespace

BallFilter::BallFilter(const Vec2& detected_m, Time captured, const BallFilterParams& params)
    : x_(start(detected_m.x(), params)), y_(start(detected_m.y(), params)), time_(captured), corrected_(captured) {}

void BallFilter::advance(Time until, const BallFilterParams& params) {
  if (until <= time_) return;
  const BallState rolled = predicted(state({}), until - time_, params.rolling_deceleration_mps2);
  const double dt_s = to_seconds(until - time_);
  regista::advance(x_, dt_s, params.acceleration_density_m2ps3);
  regista::advance(y_, dt_s, params.acceleration_density_m2ps3);
  x_.value = rolled.position_m.x();
  y_.value = rolled.position_m.y();
  x_.rate = rolled.velocity_mps.x();
  y_.rate = rolled.velocity_mps.y();
  time_ = until;
}

double BallFilter::distance_m(const Vec2& detected_m, Time captured) const {
  const double delay_s = to_seconds(time_ - captured);
  return (detected_m - Vec2(x_.value - x_.rate * delay_s, y_.value - y_.rate * delay_s)).norm();
}

bool BallFilter::accepts(const Vec2& detected_m, Time captured, const BallFilterParams& params) const {
  const double unseen_s = std::abs(to_seconds(captured - corrected_));
  return distance_m(detected_m, captured) <= params.gate_m + params.speed_max_mps * unseen_s;
}

void BallFilter::correct(const Vec2& detected_m, Time captured, const BallFilterParams& params) {
  const double delay_s = to_seconds(time_ - captured);
  // Only time can hold a kick: a second camera's view of the same moment is an offset, not a motion.
  if (captured > corrected_ && distance_m(detected_m, captured) > params.kick_m) {
    const double speed_variance = params.speed_sigma_mps * params.speed_sigma_mps;
    add_kick(x_, to_seconds(captured - corrected_), speed_variance);
    add_kick(y_, to_seconds(captured - corrected_), speed_variance);
  }
  const double noise_m2 = params.position_sigma_m * params.position_sigma_m;
  regista::correct(x_, detected_m.x() - (x_.value - x_.rate * delay_s), delay_s, noise_m2);
  regista::correct(y_, detected_m.y() - (y_.value - y_.rate * delay_s), delay_s, noise_m2);
  corrected_ = std::max(corrected_, captured);
}

BallState BallFilter::state(Duration age) const {
  return {{x_.value, y_.value}, {x_.rate, y_.rate}, x_.variance, x_.rate_variance, age};
}

}  // namespace regista
