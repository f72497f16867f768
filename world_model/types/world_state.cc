#include "world_model/types/world_state.h"

#include <algorithm>

namespace regista {

const RobotState* find_robot(const WorldState& world, RobotId id) {
  const auto it = std::lower_bound(world.robots.begin(), world.robots.end(), id,
                                   [](const RobotState& robot, RobotId wanted) { return robot.id < wanted; });
  return it != world.robots.end() && it->id == id ? &*it : nullptr;
}

}  // namespace regista
