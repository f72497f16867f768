// A camera: turns the true field into vision frames, with noise, missing objects and delay. One camera sees the whole
// field as yet; each further one is another object with its own number.
#pragma once

#include <vector>

#include "sim/ball_model.h"
#include "sim/random.h"
#include "sim/robot_model.h"
#include "sim/sim_params.h"
#include "world_model/types/vision_frame.h"

namespace regista {

class Camera {
 public:
  /// The first frame is due at `start`, frame k at start + k / rate.
  Camera(std::uint32_t number, const VisionParams& params, std::uint64_t seed, Time start);

  Time next_capture() const;
  Duration latency() const { return from_seconds(params_.latency_s); }

  /// Takes the next frame now, which may be later than it was due (the simulator's step is what it can see).
  VisionFrame capture(const std::vector<RobotBody>& robots, const BallBody& ball, Time now);

 private:
  std::uint32_t number_;
  VisionParams params_;
  Random random_;
  Time start_;
  std::uint32_t frames_ = 0;
};

}  // namespace regista
