// A camera: turns what it sees of the true field into vision frames, with noise, missing objects, delay and a
// calibration that is a little off.
#pragma once

#include <vector>

#include "sim/ball_model.h"
#include "sim/camera_view.h"
#include "sim/random.h"
#include "sim/robot_model.h"
#include "sim/sim_params.h"
#include "world_model/types/vision_frame.h"

namespace regista {

class Camera {
 public:
  /// The first frame is due at `start`, frame k at start + k / rate. Nothing outside of the view is seen.
  Camera(std::uint32_t number, const VisionParams& params, std::uint64_t seed, Time start, const CameraView& view = {});

  Time next_capture() const;
  Duration latency() const { return from_seconds(params_.latency_s); }
  /// What is added to every place it sees, at most params.camera_shift_max_m long.
  const Vec2& shift_m() const { return shift_m_; }

  /// Takes the next frame now, which may be later than it was due (the simulator's step is what it can see).
  VisionFrame capture(const std::vector<RobotBody>& robots, const BallBody& ball, Time now);

 private:
  std::uint32_t number_;
  VisionParams params_;
  Random random_;
  Time start_;
  CameraView view_;
  Vec2 shift_m_;
  std::uint32_t frames_ = 0;
};

}  // namespace regista
