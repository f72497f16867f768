// The ball's position and velocity from noisy detections: a Kalman filter per axis around a ball that rolls to rest,
// opened wide when a kick shows. Used by the world model, which decides what detection is the ball.
#pragma once

#include "world_model/axis_filter.h"
#include "world_model/params.h"
#include "world_model/types/world_state.h"

namespace regista {

/// Noise: `noisy` vision of the league (1.4 mm). Friction: rolling on the league's carpets, 0.2–0.4 m/s²; the sliding
/// after a kick (3–4 m/s² for some tenths of a second) is left to the process noise.
struct BallFilterParams {
  double position_sigma_m = 0.0014;
  double acceleration_density_m2ps3 = 0.3;
  double rolling_deceleration_mps2 = 0.35;
  double speed_sigma_mps = 3.0;
  double speed_max_mps = 6.5;  // SSL rules: the fastest legal shot
  double gate_m = 0.1;
  double kick_m = 0.03;  // beyond the 20 mm by which cameras disagree
  bool operator==(const BallFilterParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("position_sigma_m", self.position_sigma_m, Range{1e-6, 0.1}, "m", "noise of a detected position, per axis");
    v("acceleration_density_m2ps3", self.acceleration_density_m2ps3, Range{1e-6, 1e4}, "m2/s3",
      "spectral density of accelerations other than rolling friction");
    v("rolling_deceleration_mps2", self.rolling_deceleration_mps2, Range{0.0, 10.0}, "m/s2", "of a rolling ball");
    v("speed_sigma_mps", self.speed_sigma_mps, Range{0.01, 20.0}, "m/s", "speed at first sight and after a kick");
    v("speed_max_mps", self.speed_max_mps, Range{0.0, 30.0}, "m/s", "a ball further away than this allows is false");
    v("gate_m", self.gate_m, Range{0.0, 10.0}, "m", "and further away than this on top");
    v("kick_m", self.kick_m, Range{0.001, 10.0}, "m", "a ball this far from the prediction was kicked");
  }
};

class BallFilter {
 public:
  /// A ball seen for the first time, at rest as far as is known. The position must be finite.
  BallFilter(const Vec2& detected_m, Time captured, const BallFilterParams& params);

  Time time() const { return time_; }

  /// Rolls the estimate on to a later time; an earlier one changes nothing.
  void advance(Time until, const BallFilterParams& params);

  /// Metres between the detection and where the ball should have been at `captured` <= time().
  double distance_m(const Vec2& detected_m, Time captured) const;

  /// Whether a detection of `captured` <= time() is near enough, kicks included, to be this ball.
  bool accepts(const Vec2& detected_m, Time captured, const BallFilterParams& params) const;

  /// Takes in a detection of `captured` <= time(): older than the estimate, it is compared with where the ball was.
  void correct(const Vec2& detected_m, Time captured, const BallFilterParams& params);

  /// Puts the estimate elsewhere, as when the frame it is told in moves; velocity and certainty stay.
  void shift(const Vec2& by_m) {
    x_.value += by_m.x();
    y_.value += by_m.y();
  }

  /// The estimate at time().
  BallState state(Duration age) const;

 private:
  AxisFilter x_;  // m
  AxisFilter y_;
  Time time_;
  Time corrected_;  // capture time of the newest detection taken in
};

}  // namespace regista
