// One robot's pose and velocity from noisy detections: a Kalman filter per axis and one for the heading, with the
// motion commanded to the robot as known input. Used by the world model, which decides what detection is whose.
#pragma once

#include <optional>
#include <span>

#include "world_model/axis_filter.h"
#include "world_model/params.h"
#include "world_model/types/body_velocity.h"
#include "world_model/types/world_state.h"

namespace regista {

/// Noise: moving robots under the league's vision, 1.3 mm and 10 mrad; one camera over a small field can be three times
/// better. Densities: fitted on the first half of a recording of a real robot (50 Hz SSL-Vision, up to 1 m/s), see
/// tests/world_model/real_recording_test.cc.
struct RobotFilterParams {
  double position_sigma_m = 0.0013;
  double heading_sigma_rad = 0.01;
  double acceleration_density_m2ps3 = 0.1;
  double angular_acceleration_density_rad2ps3 = 12.0;
  double speed_sigma_mps = 1.5;            // robots of the league drive up to 3 m/s
  double angular_speed_sigma_radps = 5.0;  // and turn up to 10 rad/s
  double gate_m = 0.1;                     // a robot's radius away it is another robot, whatever the pattern says
  double gate_rad = 0.5;                   // 10 rad/s reached or lost unseen over 50 ms
  double gate_sigmas = 5.0;
  bool operator==(const RobotFilterParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("position_sigma_m", self.position_sigma_m, Range{1e-6, 0.1}, "m", "noise of a detected position, per axis");
    v("heading_sigma_rad", self.heading_sigma_rad, Range{1e-6, 1.0}, "rad", "noise of a detected heading");
    v("acceleration_density_m2ps3", self.acceleration_density_m2ps3, Range{1e-6, 1e3}, "m2/s3",
      "spectral density of accelerations that no command explains");
    v("angular_acceleration_density_rad2ps3", self.angular_acceleration_density_rad2ps3, Range{1e-6, 1e5}, "rad2/s3",
      "spectral density of angular accelerations that no command explains");
    v("speed_sigma_mps", self.speed_sigma_mps, Range{0.01, 20.0}, "m/s", "speed of a robot seen for the first time");
    v("angular_speed_sigma_radps", self.angular_speed_sigma_radps, Range{0.01, 100.0}, "rad/s",
      "angular speed of a robot seen for the first time");
    v("gate_m", self.gate_m, Range{0.0, 10.0}, "m", "a detection this far from the prediction may be false");
    v("gate_rad", self.gate_rad, Range{0.0, 7.0}, "rad", "a heading this far from the prediction may be false");
    v("gate_sigmas", self.gate_sigmas, Range{0.0, 100.0}, "", "added to both gates: sigmas of the prediction");
  }
};

/// What a robot was told and how it follows; see predicted() in prediction.h.
struct CommandModel {
  std::span<const SentVelocity> sent;  ///< sorted by capture time; empty: nothing known
  Duration latency{};
  double velocity_lag_s = 0.0;
};

class RobotFilter {
 public:
  /// A robot seen for the first time, at rest as far as is known. The pose must be finite.
  RobotFilter(const Pose& detected, Time captured, const RobotFilterParams& params);

  Time time() const { return time_; }

  /// Moves the estimate to a later time; an earlier one changes nothing. Commands enter as *change* of velocity: the
  /// response they ask for moves the estimate along, but a robot that drives otherwise (is pushed, slips) keeps the
  /// velocity that vision shows. Without commands: constant velocity and rate.
  void advance(Time until, const CommandModel& commands, const RobotFilterParams& params);

  /// Metres between the detection and where the robot should have been at `captured` <= time().
  double distance_m(const Pose& detected, Time captured) const;

  /// Whether a detection of `captured` <= time() is near enough to be this robot.
  bool accepts(const Pose& detected, Time captured, const RobotFilterParams& params) const;

  /// Takes in a detection of `captured` <= time(): older than the estimate, it is compared with where the robot was.
  void correct(const Pose& detected, Time captured, const RobotFilterParams& params);

  /// Puts the estimate elsewhere, as when the frame it is told in moves; velocity and certainty stay.
  void shift(const Vec2& by_m) {
    x_.value += by_m.x();
    y_.value += by_m.y();
  }

  /// The estimate at time().
  RobotState state(RobotId id, Duration age) const;

  const AxisFilter& x() const { return x_; }
  const AxisFilter& y() const { return y_; }
  const AxisFilter& heading() const { return heading_; }

 private:
  AxisFilter x_;  // m
  AxisFilter y_;
  AxisFilter heading_;  // rad, value in (-π, π]
  Time time_;
  std::optional<BodyVelocity> response_;  // to the commands, were it as modelled; none while no command acts
};

}  // namespace regista
