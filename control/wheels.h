// Kinematics of a robot on four omni wheels: body velocity to wheel speeds for the command, wheel speeds to body
// velocity for odometry. Wheel order: front left, back left, back right, front right.
#pragma once

#include <Eigen/Core>
#include <array>
#include <numbers>
#include <string>

#include "world_model/params.h"
#include "world_model/types/body_velocity.h"

namespace regista {

/// Radians per second, one per wheel; positive rolls the hub counter-clockwise around the robot's centre.
using WheelSpeeds = std::array<double, 4>;

/// Where the wheels are; a bearing is the angle from forward to the hub, positive to the left. The right wheels mirror
/// the left ones unless all four bearings are given.
/// Bearings and wheel diameter (61 mm) as in section II of the paper on iterative RRT with smoothing for robot soccer,
/// which gives the axes' angles to the lateral axis: 33° in front, 45° at the back.
struct WheelGeometry {
  double front_bearing_rad = 57.0 * std::numbers::pi / 180.0;
  double rear_bearing_rad = 135.0 * std::numbers::pi / 180.0;
  std::string
      bearings_rad;  ///< all four in the order of the wheels, "0.99,2.36,-2.36,-0.99"; empty: from the two above
  double hub_radius_m = 0.08;  ///< centre to the wheel's plane: what fits under a body of 0.09 m
  double wheel_radius_m = 0.0305;
  /// 4.9 m/s at the rim. A body at its default limits, 3 m/s while turning with 10 rad/s, needs at most
  /// (3 + 10·0.08) / 0.0305 = 125 rad/s, so this bites only where a robot is given faster limits or slower wheels.
  double wheel_speed_max_radps = 160.0;
  bool operator==(const WheelGeometry&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    // Ranges keep the front wheels in front, the rear ones at the back: any such four span all three motions.
    v("front_bearing_rad", self.front_bearing_rad, Range{0.2, 1.5}, "rad", "forward to the front wheels' hubs");
    v("rear_bearing_rad", self.rear_bearing_rad, Range{1.6, 3.0}, "rad", "forward to the rear wheels' hubs");
    v("bearings_rad", self.bearings_rad, Range{}, "rad",
      "forward to all four hubs: front left, back left, back right, front right, with commas; empty: mirrored");
    v("hub_radius_m", self.hub_radius_m, Range{0.01, 1.0}, "m", "centre to the wheels");
    v("wheel_radius_m", self.wheel_radius_m, Range{0.005, 0.5}, "m", "radius of the wheels");
    v("wheel_speed_max_radps", self.wheel_speed_max_radps, Range{1.0, 2000.0}, "rad/s", "largest speed of a wheel");
  }
};

class OmniWheels {
 public:
  /// Throws std::invalid_argument when the wheels cannot drive all three motions, a length is not positive, or
  /// bearings_rad is neither empty nor four numbers within ±2π.
  explicit OmniWheels(const WheelGeometry& geometry);

  /// Exact for every body velocity; may exceed the wheels' limit.
  WheelSpeeds speeds(const BodyVelocity& body) const;

  /// The body velocity that explains the wheel speeds best in the least-squares sense; velocity(speeds(v)) = v.
  BodyVelocity velocity(const WheelSpeeds& wheels) const;

  /// The factor in (0, 1] all wheels must be slowed by so that none is above the limit; the direction stays.
  double scale_to_limit(const WheelSpeeds& wheels) const;

 private:
  Eigen::Matrix<double, 4, 3> to_wheels_;
  Eigen::Matrix<double, 3, 4> to_body_;  ///< pseudo-inverse of to_wheels_
  double speed_max_radps_;
};

}  // namespace regista
