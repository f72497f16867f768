// The ball: slides after a kick, rolls from a fixed part of its start speed on, comes to rest; robots push and kick it.
// Two-phase model as league simulators use it; the numbers are in BallParams.
#pragma once

#include "sim/robot_model.h"
#include "sim/sim_params.h"

namespace regista {

struct BallBody {
  Vec2 position_m = Vec2::Zero();
  Vec2 velocity_mps = Vec2::Zero();
  double rolls_below_mps = 0.0;  ///< slides while faster than this
  bool operator==(const BallBody&) const = default;
};

/// A kicker reaches the ball when the gap between both is at most this. Metres; play of a real kicker's plate.
inline constexpr double kKickReach_m = 0.02;
/// Half the angle of a robot's front in which the ball can be kicked. Radians; 20°, about the width of a mouth.
inline constexpr double kKickHalfAngle_rad = 0.349;

/// Gives the ball a new velocity, cut to params.speed_max_mps; it starts to slide.
void kick(BallBody& ball, const Vec2& velocity_mps, const BallParams& params);

/// Moves the ball on by dt_s, exactly, through both phases.
void step(BallBody& ball, const BallParams& params, double dt_s);

/// Keeps the ball out of a robot's disc. A ball that was approaching has the robot's velocity along the line of centres
/// afterwards and rolls.
void push(BallBody& ball, const RobotBody& robot, double robot_radius_m, const BallParams& params);

/// True when the robot's kicker can reach the ball.
bool can_kick(const BallBody& ball, const RobotBody& robot, double robot_radius_m, const BallParams& params);

}  // namespace regista
