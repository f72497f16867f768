// From a path and a robot's state to the velocity it shall have next: drive towards a point a little ahead on the path,
// as fast as corners and end ahead permit (pure pursuit with a backward speed profile).
#pragma once

#include <span>

#include "control/control_params.h"

namespace regista {

/// Where on a path a robot is: vertices up to `leg` are passed.
struct PathPosition {
  std::size_t leg = 0;        ///< the leg from path[leg] to path[leg + 1]; 0 for a path of one point
  Vec2 point = Vec2::Zero();  ///< the point of the path nearest to the robot
  double distance_m = 0.0;    ///< robot to point
};

/// Of equally near points the last one on the path. The path must have a point.
PathPosition locate(std::span<const Vec2> path, const Vec2& position_m);

/// The largest speed at which a bend of turn_rad in [0, π], spread over bend_length_m of the path, is driven with
/// `acceleration` to the side and at most tolerance_m beside the vertices: √(acceleration·ρ). Infinite for no bend.
///
/// Derivation: an arc tangent to two legs that meet under the turn φ passes the vertex at ρ(1/cos(φ/2) − 1); set equal
/// to the tolerance this gives the radius for a bend in one vertex. A bend spread over a length ℓ has ρ = ℓ/φ by
/// itself; the sum of both has both limits.
double bend_speed(double turn_rad, double bend_length_m, double acceleration, double tolerance_m);

/// The velocity, field frame, for the next dt_s: `velocity_mps` is the present one. Comes to rest at the path's end.
/// Works from anywhere, also beside or beyond the path. The path must have a point, all numbers must be finite. The
/// result is no faster than limits.speed_max_mps, but only motion_limits.h makes it reachable within dt_s.
Vec2 follow_path(std::span<const Vec2> path, const Vec2& position_m, const Vec2& velocity_mps,
                 const RobotLimits& limits, const FollowerParams& params, double dt_s);

}  // namespace regista
