// What a robot's body can do, shared by planning, control and simulator.
#pragma once

#include "world_model/params.h"

namespace regista {

/// Defaults: the middle of what league teams use (2.0–3.2 m/s, 2–4.5 m/s² up, up to 6 m/s² brake, 6–10 rad/s) and the
/// largest legal radius (SSL rules, "Robot shape").
struct RobotLimits {
  double radius_m = 0.09;                         ///< > 0
  double speed_max_mps = 3.0;                     ///< > 0
  double acceleration_max_mps2 = 3.0;             ///< speeding up, > 0
  double braking_max_mps2 = 4.0;                  ///< slowing down, > 0
  double angular_speed_max_radps = 10.0;          ///< > 0
  double angular_acceleration_max_radps2 = 50.0;  ///< > 0
  bool operator==(const RobotLimits&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("radius_m", self.radius_m, Range{0.01, 1.0}, "m", "radius of the body");
    v("speed_max_mps", self.speed_max_mps, Range{0.01, 20.0}, "m/s", "largest speed");
    v("acceleration_max_mps2", self.acceleration_max_mps2, Range{0.01, 100.0}, "m/s²", "largest acceleration");
    v("braking_max_mps2", self.braking_max_mps2, Range{0.01, 100.0}, "m/s²", "largest deceleration");
    v("angular_speed_max_radps", self.angular_speed_max_radps, Range{0.01, 100.0}, "rad/s", "largest turning rate");
    v("angular_acceleration_max_radps2", self.angular_acceleration_max_radps2, Range{0.1, 1000.0}, "rad/s²",
      "largest change of the turning rate per second");
  }
};

}  // namespace regista
