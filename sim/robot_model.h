// A robot's body: how it follows a velocity command within its limits. Used by the simulator; kinematic, no wheels.
#pragma once

#include "world_model/types/body_velocity.h"
#include "world_model/types/robot_id.h"
#include "world_model/types/robot_limits.h"

namespace regista {

struct RobotBody {
  RobotId id;
  Pose pose;
  Twist twist;  ///< field frame
  bool operator==(const RobotBody&) const = default;
};

/// Largest part of `change_mps` the body can do in dt_s when it moves with velocity_mps: the acceleration lies in a
/// half disc ahead (speeding up) and a half ellipse behind (slowing down, longer by the braking limit); direction is
/// kept.
Vec2 limited_change(const Vec2& velocity_mps, const Vec2& change_mps, const RobotLimits& limits, double dt_s);

/// Moves the body on by dt_s > 0 (one millisecond or so). The command, cut to the speed limits and turned by the true
/// heading, is followed with a first-order lag (time constant velocity_lag_s >= 0), then cut to the acceleration
/// limits; the pose is integrated by the trapezoid rule.
void step(RobotBody& body, const BodyVelocity& commanded, const RobotLimits& limits, double velocity_lag_s,
          double dt_s);

/// The same without command: full braking without lag, to an exact stop.
void brake(RobotBody& body, const RobotLimits& limits, double dt_s);

}  // namespace regista
