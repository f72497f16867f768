// Everything that can be tuned in control: one struct per stage, listed once, with the defaults' reasons.
#pragma once

#include "control/safety/rough_play.h"
#include "control/safety/safety_params.h"
#include "control/velocity_choice.h"
#include "control/wheels.h"
#include "world_model/params.h"
#include "world_model/types/robot_limits.h"

namespace regista {

/// How a path becomes a velocity.
struct FollowerParams {
  double corner_tolerance_m = 0.02;  ///< how far a corner may be rounded
  /// Corners are not driven slower than this, however sharp: with a new path from where the robot is every tick, and
  /// a safety search behind it, optimism does no harm.
  double corner_speed_min_mps = 2.0;
  double pursuit_distance_m = 0.05;  ///< the point steered for is so far ahead on the path
  double pursuit_time_s = 0.12;      ///< and farther by the speed times this
  /// While speeding up, so much of the possible change of velocity may go into motion across the path. Paths among
  /// moving robots swing a little all the time; to follow each swing at once starves speeding up (0.9: 3 % fewer
  /// targets).
  double across_share = 0.5;
  double braking_share = 1.0;        ///< of the braking limit that profiles use; planned anew every tick, all of it
  double settle_time_s = 0.05;       ///< time constant of the last centimetres: slower than the drive's lag
  double settle_distance_m = 0.002;  ///< nearer counts as there: just above the noise of vision, 1.3 mm
  bool operator==(const FollowerParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("corner_tolerance_m", self.corner_tolerance_m, Range{0.001, 1.0}, "m", "how far a corner may be rounded");
    v("corner_speed_min_mps", self.corner_speed_min_mps, Range{0.01, 20.0}, "m/s", "least speed at a corner");
    v("pursuit_distance_m", self.pursuit_distance_m, Range{0.0, 1.0}, "m", "the path is steered for so far ahead");
    v("pursuit_time_s", self.pursuit_time_s, Range{0.0, 1.0}, "s", "and farther by the speed times this");
    v("across_share", self.across_share, Range{0.05, 1.0}, "",
      "share of the acceleration that may go across the path while speeding up");
    v("braking_share", self.braking_share, Range{0.1, 1.0}, "", "share of the braking limit that profiles use");
    v("settle_time_s", self.settle_time_s, Range{0.001, 2.0}, "s", "time constant of the last centimetres");
    v("settle_distance_m", self.settle_distance_m, Range{0.0, 0.1}, "m", "nearer counts as there");
  }
};

/// How a heading is reached.
struct HeadingParams {
  double braking_share = 0.9;      ///< of the angular acceleration that the profile slows down with
  double settle_time_s = 0.08;     ///< as the follower's
  double settle_angle_rad = 0.01;  ///< nearer counts as there: the noise of vision
  bool operator==(const HeadingParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("braking_share", self.braking_share, Range{0.1, 1.0}, "", "share of the angular acceleration for slowing down");
    v("settle_time_s", self.settle_time_s, Range{0.001, 2.0}, "s", "time constant of the last degrees");
    v("settle_angle_rad", self.settle_angle_rad, Range{0.0, 0.5}, "rad", "nearer counts as there");
  }
};

struct ControlParams {
  RobotLimits limits;
  FollowerParams follower;
  HeadingParams heading;
  VelocityChoiceParams velocity_choice;
  SafetyParams safety;
  RoughPlayParams rough_play;
  WheelGeometry wheels;
  std::string robot_wheels;        ///< exceptions of single robots, as TeamWheels reads them
  double plan_deadline_s = 0.2;    ///< a plan older than this is no plan: 20 world states at 100 Hz
  double world_deadline_s = 0.1;   ///< without a world state for so long all robots brake
  double unseen_deadline_s = 0.2;  ///< a robot that vision lost for so long brakes: at 3 m/s it went 0.6 m blind
  /// Time constant with which a robot's velocity follows its command, 30 ms for league robots. Too large a value brakes
  /// earlier than needed, too small a one overshoots by its error times the speed.
  double drive_lag_s = 0.03;
  /// Smoothing of opponents' accelerations: the estimate of their velocities jitters by 0.05 m/s from frame to frame.
  double acceleration_filter_s = 0.05;
  double period_s = 0.01;      ///< between ticks while no world state tells it: vision at 100 Hz
  double period_max_s = 0.05;  ///< a longer pause counts as this, so that no command jumps after it
  /// A robot further from its last command than this was hit, held or replaced. Above what lag and filter explain:
  /// 4 m/s² · 75 ms = 0.3 m/s, 50 rad/s² · 75 ms = 3.8 rad/s.
  double plausible_speed_error_mps = 0.5;
  double plausible_angular_error_radps = 5.0;
  bool operator==(const ControlParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v.group("limits", self.limits);
    v.group("follower", self.follower);
    v.group("heading", self.heading);
    v.group("velocity_choice", self.velocity_choice);
    v.group("safety", self.safety);
    v.group("rough_play", self.rough_play);
    v.group("wheels", self.wheels);
    v("robot_wheels", self.robot_wheels, Range{}, "",
      "robots with other wheels: \"3: hub_radius_m=0.07; 12: wheel_radius_m=0.03\"");
    v("plan_deadline_s", self.plan_deadline_s, Range{0.001, 10.0}, "s", "an older plan is no plan");
    v("world_deadline_s", self.world_deadline_s, Range{0.001, 10.0}, "s", "without a world state for so long, brake");
    v("unseen_deadline_s", self.unseen_deadline_s, Range{0.001, 10.0}, "s", "a robot unseen for so long brakes");
    v("drive_lag_s", self.drive_lag_s, Range{0.0, 0.5}, "s", "time constant of a robot's velocity after its command");
    v("acceleration_filter_s", self.acceleration_filter_s, Range{0.0, 1.0}, "s",
      "smoothing of opponents' accelerations");
    v("period_s", self.period_s, Range{0.0005, 0.2}, "s", "between ticks while no world state tells it");
    v("period_max_s", self.period_max_s, Range{0.0005, 0.5}, "s", "a longer pause counts as this");
    v("plausible_speed_error_mps", self.plausible_speed_error_mps, Range{0.01, 20.0}, "m/s",
      "a robot further from its last command was hit");
    v("plausible_angular_error_radps", self.plausible_angular_error_radps, Range{0.1, 100.0}, "rad/s",
      "likewise for the turning rate");
  }
};

}  // namespace regista
