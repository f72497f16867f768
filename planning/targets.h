// What a team's robots are asked to do: the input of planning beside the world.
#pragma once

#include <cstdint>
#include <vector>

#include "world_model/types/geometry.h"
#include "world_model/types/robot_id.h"
#include "world_model/types/time.h"

namespace regista {

struct Target {
  std::uint16_t robot = 0;          ///< number within the team
  Pose pose;                        ///< where to be and where to look
  double speed_max_mps = 3.0;       ///< >= 0, on top of the robot's own limit
  bool may_enter_own_area = false;  ///< the goalkeeper's privilege
  bool operator==(const Target&) const = default;
};

struct Targets {
  Time captured{};  ///< capture time of the world the targets were chosen from
  Team team = Team::yellow;
  std::uint64_t sequence = 0;   ///< counts up with every message
  std::vector<Target> targets;  ///< sorted by robot, each robot at most once; a robot without target stands
  bool operator==(const Targets&) const = default;
};

}  // namespace regista
