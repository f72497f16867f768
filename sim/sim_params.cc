#include "sim/sim_params.h"

#include <stdexcept>

namespace regista {
namespace {

// Noise of real vision on moving robots and balls, and the delays one team measured on its robots.
SimParams noisy() {
  SimParams params;
  params.vision.robot_sigma_m = 0.0013;
  params.vision.heading_sigma_rad = 0.01;
  params.vision.ball_sigma_m = 0.0014;
  params.radio.latency_s = 0.030;
  params.velocity_lag_s = 0.030;
  return params;
}

// As noisy, and what gets lost or late: 35 ms camera and 10 ms processing, losses as counted in recorded games; two
// cameras whose pictures of one object lie up to 20 mm beside it.
SimParams realistic() {
  SimParams params = noisy();
  params.vision.latency_s = 0.045;
  params.vision.robot_dropout = 0.02;
  params.vision.ball_dropout = 0.05;
  params.vision.cameras = 2;
  params.vision.camera_overlap_m = 0.3;
  params.vision.camera_shift_max_m = 0.020;
  params.radio.loss = 0.03;
  return params;
}

}  // namespace

std::vector<std::string> sim_preset_names() { return {"none", "noisy", "realistic"}; }

SimParams sim_preset(std::string_view name) {
  if (name == "none") return {};
  if (name == "noisy") return noisy();
  if (name == "realistic") return realistic();
  throw std::invalid_argument("unknown simulator preset '" + std::string(name) +
                              "', there are: none, noisy, realistic");
}

}  // namespace regista
