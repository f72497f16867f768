// The estimate of everything on the field at one moment: the output of the world model, the input of all that decides.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "world_model/types/geometry.h"
#include "world_model/types/robot_id.h"
#include "world_model/types/time.h"

namespace regista {

struct RobotState {
  RobotId id;
  Pose pose;
  Twist twist;                           ///< field frame
  double position_variance_m2 = 0.0;     ///< per axis
  double velocity_variance_m2ps2 = 0.0;  ///< per axis
  double heading_variance_rad2 = 0.0;
  Duration age{};  ///< since the robot was last seen
  bool operator==(const RobotState&) const = default;
};

struct BallState {
  Vec2 position_m = Vec2::Zero();
  Vec2 velocity_mps = Vec2::Zero();
  double position_variance_m2 = 0.0;     ///< per axis
  double velocity_variance_m2ps2 = 0.0;  ///< per axis
  Duration age{};                        ///< since the ball was last seen
  bool operator==(const BallState&) const = default;
};

struct WorldState {
  Time captured{};                 ///< capture of the newest frame in it
  Time valid_at{};                 ///< the moment poses and velocities are predicted to: when a command sent now acts
  std::uint64_t sequence = 0;      ///< counts up with every state published
  std::vector<RobotState> robots;  ///< sorted by id, each id once
  std::optional<BallState> ball;
  bool operator==(const WorldState&) const = default;
};

/// The robot of that id, or nullptr where the state has none. Logarithmic in the number of robots.
const RobotState* find_robot(const WorldState& world, RobotId id);

}  // namespace regista
