// What the simulated field is like: cameras, radio, robots' bodies, ball. Presets follow what real fields and teams of
// the league show; all values are defaults of a field without any disturbance.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "world_model/params.h"
#include "world_model/types/robot_limits.h"

namespace regista {

struct VisionParams {
  double rate_hz = 100.0;
  double latency_s = 0.0;  ///< capture to sent
  double robot_sigma_m = 0.0;
  double heading_sigma_rad = 0.0;
  double ball_sigma_m = 0.0;
  double robot_dropout = 0.0;
  double ball_dropout = 0.0;
  std::int64_t cameras = 1;         ///< in turn: their frames are evenly spread over the period
  double camera_overlap_m = 0.3;    ///< width of the strip that two neighbours see
  double camera_shift_max_m = 0.0;  ///< each one's calibration is off by up to this, drawn from the seed
  bool operator==(const VisionParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("rate_hz", self.rate_hz, Range{1, 1000}, "1/s", "frames per second and camera");
    v("latency_s", self.latency_s, Range{0, 1}, "s", "from capture to sent");
    v("robot_sigma_m", self.robot_sigma_m, Range{0, 1}, "m", "standard deviation of a robot's position, per axis");
    v("heading_sigma_rad", self.heading_sigma_rad, Range{0, 1}, "rad", "standard deviation of a robot's heading");
    v("ball_sigma_m", self.ball_sigma_m, Range{0, 1}, "m", "standard deviation of the ball's position, per axis");
    v("robot_dropout", self.robot_dropout, Range{0, 1}, "", "probability that a robot is missing in a frame");
    v("ball_dropout", self.ball_dropout, Range{0, 1}, "", "probability that the ball is missing in a frame");
    v("cameras", self.cameras, Range{1, 8}, "", "how many share the field: side by side, from 4 on in two rows");
    v("camera_overlap_m", self.camera_overlap_m, Range{0, 10}, "m", "width of the strip that two neighbours see");
    v("camera_shift_max_m", self.camera_shift_max_m, Range{0, 1}, "m", "largest error of a camera's place");
  }
};

struct RadioParams {
  double latency_s = 0.0;  ///< arrival at the simulator to effect
  double loss = 0.0;       ///< per robot and command
  double timeout_s = 0.1;  ///< as simulators of the league have it
  bool operator==(const RadioParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("latency_s", self.latency_s, Range{0, 1}, "s", "from a command's arrival to its effect");
    v("loss", self.loss, Range{0, 1}, "", "probability that a robot's command is lost");
    v("timeout_s", self.timeout_s, Range{0.001, 10}, "s", "a robot without command for so long brakes");
  }
};

struct BallParams {
  double radius_m = 0.0215;              ///< SSL rules, "Ball"
  double slide_deceleration_mps2 = 3.9;  ///< real carpets: 3–4
  double roll_deceleration_mps2 = 0.35;  ///< real carpets: 0.2–0.4
  double roll_ratio = 0.69;              ///< rolls from this part of its start speed on; 5/7 for a solid sphere
  double speed_max_mps = 6.5;            ///< SSL rules, "Ball speed"
  double wall_restitution = 0.5;         ///< part of the normal speed left after a wall; a guess, boards are low
  bool operator==(const BallParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("radius_m", self.radius_m, Range{0.001, 0.5}, "m", "radius");
    v("slide_deceleration_mps2", self.slide_deceleration_mps2, Range{0.01, 100}, "m/s^2", "while it slides");
    v("roll_deceleration_mps2", self.roll_deceleration_mps2, Range{0.01, 100}, "m/s^2", "while it rolls");
    v("roll_ratio", self.roll_ratio, Range{0, 1}, "", "rolls from this part of its start speed on");
    v("speed_max_mps", self.speed_max_mps, Range{0.1, 20}, "m/s", "what a kicker can give it");
    v("wall_restitution", self.wall_restitution, Range{0, 1}, "", "part of the normal speed left after a wall");
  }
};

struct SimParams {
  double velocity_lag_s = 0.0;  ///< time constant of a body's first-order answer to its command
  double velocity_gain = 1.0;   ///< part of its command that a body drives and turns
  RobotLimits limits;
  VisionParams vision;
  RadioParams radio;
  BallParams ball;
  bool operator==(const SimParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("velocity_lag_s", self.velocity_lag_s, Range{0, 1}, "s", "time constant of a robot's answer to its command");
    v("velocity_gain", self.velocity_gain, Range{0, 2}, "", "a robot drives and turns this factor of its command");
    v.group("limits", self.limits);
    v.group("vision", self.vision);
    v.group("radio", self.radio);
    v.group("ball", self.ball);
  }
};

/// Names sim_preset knows, mildest first.
std::vector<std::string> sim_preset_names();

/// `none`: exact and immediate. `noisy`: vision noise at 100 Hz, command delay and lag, nothing lost. `realistic`:
/// noise, delays and losses as on real fields, seen by two shifted cameras that overlap. Throws std::invalid_argument
/// naming the presets for any other name.
SimParams sim_preset(std::string_view name);

}  // namespace regista
