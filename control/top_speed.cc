#include "control/top_speed.h"

#include <algorithm>

namespace regista {
namespace {

constexpr double kWatch_s = 0.5;  ///< by then who drives at all is near its speed

/// So a push to 1 m/s more than they drive by themselves counts for five seconds; of several robots that drive one is
/// always at its speed.
constexpr double kForgotten_mps2 = 0.2;

/// Robots of the league get to that at least: a team that is slow is being careful or is told to, as in a stop.
constexpr double kLeast_mps = 2.0;

}  // namespace

void TopSpeed::update(const WorldState& world, Team team, double dt_s) {
  watched_s_ += dt_s;
  fastest_mps_ = std::max(kLeast_mps, fastest_mps_ - kForgotten_mps2 * dt_s);
  for (const RobotState& robot : world.robots) {
    if (robot.id.team == team) fastest_mps_ = std::max(fastest_mps_, robot.twist.velocity_mps.norm());
  }
}

double TopSpeed::mps() const { return watched_s_ >= kWatch_s ? fastest_mps_ : std::numeric_limits<double>::infinity(); }

}  // namespace regista
