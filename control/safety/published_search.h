// Dynamic safety search as the visibility-sampling paper tells it ("Control, Trajectory, and Dynamic Safety Search"):
// one robot at a time is controlled, all others, team-mates included, are not. The paper gives no numbers; those here
// are guesses, named where they stand.
#pragma once

#include <span>

#include "control/safety/opponent.h"
#include "control/safety/safety_params.h"
#include "control/safety/safety_robot.h"
#include "world_model/types/robot_limits.h"

namespace regista {

/// The velocity after this period for robot `self` of the team: obstacles within a range accelerate in sampled
/// directions; if one of them hits the robot on its wanted way within a short time, the sampled change of the robot's
/// velocity that avoids most hits, among equals the smallest, is added.
Vec2 published_choice(std::span<const SafetyRobot> team, std::size_t self, std::span<const Opponent> opponents,
                      const RobotLimits& limits, const SafetyParams& params, double period_s);

}  // namespace regista
