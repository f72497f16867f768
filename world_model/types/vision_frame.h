// What one camera saw at one moment: the input of the world model.
#pragma once

#include <cstdint>
#include <vector>

#include "world_model/types/geometry.h"
#include "world_model/types/robot_id.h"
#include "world_model/types/time.h"

namespace regista {

struct RobotDetection {
  RobotId id;
  Pose pose;
  double confidence = 1.0;  ///< 0–1
  bool operator==(const RobotDetection&) const = default;
};

struct BallDetection {
  Vec2 position_m = Vec2::Zero();
  double confidence = 1.0;  ///< 0–1
  bool operator==(const BallDetection&) const = default;
};

struct VisionFrame {
  Time captured{};  ///< when the light fell in; the stamp of all that is made from this frame
  Time sent{};      ///< when the camera's computer sent it
  std::uint32_t camera = 0;
  std::uint32_t frame_number = 0;  ///< counts up per camera
  std::vector<RobotDetection> robots;
  std::vector<BallDetection> balls;
  bool operator==(const VisionFrame&) const = default;
};

}  // namespace regista
