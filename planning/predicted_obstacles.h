// Other robots where they will be when they matter: at the moment of nearest approach to the robot that plans. A robot
// that crosses in front is gone by then, and two that come towards each other both see where they will meet.
//
// Where an opponent is after a long way is anyone's guess: it matters the less, the longer its way until then.
//
// Team-mates stop at their goals. That they drive there straight is not expected: in which direction they go around
// others shows in their velocities, and to see that is what makes a crowd turn one way.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "planning/obstacle.h"
#include "world_model/types/world_state.h"

namespace regista {

/// Keeps its velocity for so long, then stands.
struct Course {
  Vec2 from_m = Vec2::Zero();
  Vec2 velocity_mps = Vec2::Zero();
  double lasts_s = 0.0;  ///< >= 0, may be infinite

  Vec2 at(double time_s) const { return from_m + std::min(time_s, lasts_s) * velocity_mps; }
};

/// The first moment in [0, horizon_s] at which the two are nearest.
double nearest_approach_s(const Course& a, const Course& b, double horizon_s);

/// How far ahead others are expected, and how the robot itself.
struct Prediction {
  double horizon_s = 0.0;       ///< of opponents
  double team_horizon_s = 0.0;  ///< of team-mates
  double speed_mps = 0.0;       ///< at which the robot itself is expected to drive straight to its goal, and stop there
  double turn_mps2 = 0.0;       ///< by which it gets from its present velocity to that one; 0: at once
  double fade_from_m = 0.0;     ///< opponents shrink from this length of their way until the nearest approach on
  double fade_over_m = 0.0;     ///< and are gone after so much more of it; 0: they do not shrink
  bool operator==(const Prediction&) const = default;
};

/// Straight to the goal, from where the robot seems to come once it drives so: while its velocity turns it is carried
/// off by v²/2a of what the velocities differ by. Until the turn is over it is not there yet.
Course own_course(const RobotState& self, const Vec2& goal, const Prediction& prediction);

/// When a robot that drives to the goal will stand there: at the speed it has, or at least_mps where it has less.
double arrival_s(const RobotState& robot, const Vec2& goal, double least_mps);

/// `out` becomes the obstacles as robot `self` meets them: obstacle i < world.robots.size() belongs to robot i, which
/// stands from arrivals_s[i] on (one per robot, infinite where no goal is known), and is moved along its velocity to
/// the nearest approach, at most so far ahead as the prediction reaches; an opponent's shrinks with the way it goes
/// until it is met (before `self` has arrived or within the horizon), and each as far as it would cover the start, or
/// the goal without having covered it unmoved. Values are finite but for arrivals, all numbers of the prediction >= 0.
void predict(std::span<const Obstacle> obstacles, const WorldState& world, std::span<const double> arrivals_s,
             const RobotState& self, const Vec2& goal, const Prediction& prediction, std::vector<Obstacle>& out);

}  // namespace regista
