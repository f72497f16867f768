#include "control/safety/rough_play.h"

#include <cmath>

namespace regista {
namespace {

/// Who touched touches until bodies are so far apart: who pushes counts once.
constexpr double kLetGo_m = 0.05;

}  // namespace

void RoughPlay::update(const WorldState& world, Team ours, double dt_s, double radius_m,
                       const RoughPlayParams& params) {
  contacts_ *= std::exp(-dt_s / params.memory_s);
  std::set<std::pair<RobotId, RobotId>> touching;
  for (const RobotState& own : world.robots) {
    if (own.id.team != ours) continue;
    for (const RobotState& other : world.robots) {
      if (other.id.team == ours) continue;
      const Vec2 apart = other.pose.position_m - own.pose.position_m;
      const double gap_m = apart.norm() - 2.0 * radius_m;
      const std::pair pair{own.id, other.id};
      const bool touched = touching_.contains(pair);
      if (gap_m >= (touched ? kLetGo_m : params.touch_m)) continue;
      touching.insert(pair);
      if (!touched) contacts_ += 1.0;
    }
  }
  touching_.swap(touching);
}

}  // namespace regista
