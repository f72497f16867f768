#include "control/safety/expected_motion.h"

#include <algorithm>
#include <cmath>

namespace regista {
namespace {

/// cos² of the angle to straight ahead or back within which an acceleration is no turn: 18°.
constexpr double kStraightCos2 = 0.9;

/// Who is faster than its team has been seen to be by so much, and still speeds up, shows that it is not known yet.
constexpr double kFaster_mps = 0.1;

/// Robots side by side that graze go where they would have gone. Less than this is noise.
constexpr double kSlight_mps = 0.3;

Motion with(Motion motion, const Vec2& acceleration_mps2, double for_s) {
  if (for_s > 0.0) motion.then(acceleration_mps2, for_s);
  return motion;
}

/// Along `way` or nearly.
bool is_along(const Vec2& acceleration_mps2, const Vec2& way) {
  const double along = acceleration_mps2.dot(way);
  return along > 0.0 && along * along > kStraightCos2 * acceleration_mps2.squaredNorm() * way.squaredNorm();
}

/// How long who does not brake goes on accelerating.
double lasts_s(const Opponent& opponent, const SafetyParams& params) {
  const Vec2& acceleration = opponent.acceleration_mps2;
  if (!std::isfinite(opponent.speed_max_mps) || !is_along(acceleration, opponent.velocity_mps)) {
    return params.acceleration_lasts_s;
  }
  const double to_top_mps = opponent.speed_max_mps - opponent.velocity_mps.norm();
  if (to_top_mps < -kFaster_mps) return params.acceleration_lasts_s;
  return std::min(std::max(0.0, to_top_mps) / acceleration.norm(), params.speeding_up_lasts_s);
}

}  // namespace

Motion expected_motion(const Opponent& opponent, const Touch& touch, const SafetyParams& params) {
  const double horizon_s = params.horizon_s;
  const Vec2& velocity = opponent.velocity_mps;
  const Vec2& acceleration = opponent.acceleration_mps2;
  Motion motion(opponent.position_m, velocity);
  const double against = -acceleration.dot(velocity);
  const double speed2 = velocity.squaredNorm();
  const bool brakes = params.acceleration_lasts_s > 0.0 && is_along(acceleration, -velocity);
  const double touch_s = touch.change_mps.norm() > kSlight_mps ? touch.at_s : Touch{}.at_s;
  if (brakes && speed2 < against * std::min(touch_s, horizon_s)) {
    motion.then_stand(-(against / speed2) * velocity, speed2 / against);
    return motion;
  }
  if (touch_s < horizon_s) {
    motion = with(motion, Vec2::Zero(), touch_s);
    motion.hit(touch.change_mps);
    return with(motion, Vec2::Zero(), horizon_s - touch_s);
  }
  const double until_s = brakes ? horizon_s : std::min(lasts_s(opponent, params), horizon_s);
  motion = with(motion, acceleration, until_s);
  return with(motion, Vec2::Zero(), horizon_s - until_s);
}

}  // namespace regista
