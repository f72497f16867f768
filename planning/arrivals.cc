#include "planning/arrivals.h"

#include <algorithm>
#include <limits>

#include "planning/predicted_obstacles.h"

namespace regista {
namespace {

/// A robot on its way that is slower than this is about to be faster: it sets out or turns.
constexpr double kLeastOnWay_mps = 1.5;

}  // namespace

void find_arrivals(const WorldState& world, const Targets& targets, double speed_max_mps,
                   std::vector<double>& arrivals_s) {
  arrivals_s.assign(world.robots.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    const RobotState& robot = world.robots[i];
    if (robot.id.team != targets.team) continue;
    const auto target = std::ranges::find(targets.targets, robot.id.number, &Target::robot);
    if (target == targets.targets.end() || !is_finite(target->pose.position_m)) continue;
    const double least_mps = std::min({kLeastOnWay_mps, target->speed_max_mps, speed_max_mps});
    if (least_mps > 0.0) arrivals_s[i] = arrival_s(robot, target->pose.position_m, least_mps);
  }
}

}  // namespace regista
