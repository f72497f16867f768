#include "control/top_speed.h"

#include <algorithm>
#include <limits>

namespace regista {
namespace {

/// Slower than this a team shows nothing: it may stand, or drive as in a stop.
constexpr double kDrives_mps = 1.7;

/// Who speeds up more than so has not got there yet.
constexpr double kHeld_mps2 = 1.0;

constexpr double kWatched_s = 0.5;  ///< a look alone may be a mistake of vision

/// So a push to 1 m/s more than they drive by themselves counts for five seconds; of several robots that drive one is
/// nearly always at its speed.
constexpr double kForgotten_mps2 = 0.2;

}  // namespace

void TopSpeed::update(const WorldState& world, Team team, const AccelerationEstimate& accelerations, double dt_s) {
  double now_mps = 0.0;
  for (const RobotState& robot : world.robots) {
    if (robot.id.team != team) continue;
    const Vec2& velocity = robot.twist.velocity_mps;
    if (accelerations.of(robot.id).dot(velocity) > kHeld_mps2 * velocity.norm()) continue;
    now_mps = std::max(now_mps, velocity.norm());
  }
  if (now_mps < kDrives_mps) return;
  watched_s_ += dt_s;
  fastest_mps_ = std::max(now_mps, fastest_mps_ - kForgotten_mps2 * dt_s);
}

double TopSpeed::mps() const {
  return watched_s_ >= kWatched_s ? fastest_mps_ : std::numeric_limits<double>::infinity();
}

}  // namespace regista
