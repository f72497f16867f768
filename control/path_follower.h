// From a path and a robot's state to the velocity it shall have next: along the leg it is on as fast as the corners and
// the end ahead permit (backward speed profile), across it back to the path.
#pragma once

#include <span>

#include "control/control_params.h"

namespace regista {

/// The leg of the path nearest to the position, from path[leg] to path[leg + 1]; of equally near ones the last. All
/// vertices before are passed. 0 for a path of one point; the path must have a point.
std::size_t nearest_leg(std::span<const Vec2> path, const Vec2& position_m);

/// The largest speed, m/s, at which a bend of turn_rad in [0, π], spread over bend_length_m of the path, is driven at
/// most tolerance_m beside its vertices: √(acceleration·ρ). Infinite for no bend.
///
/// Derivation: from velocity v·d1 to v·d2 under constant acceleration a takes |Δv|/a with |Δv| = 2·v·sin(φ/2); that
/// parabola passes a corner at |Δv|²/(8a) = v²·sin²(φ/2)/(2a), so ρ = 2·tolerance/sin²(φ/2). A bend spread over a length
/// ℓ has ρ = ℓ/φ by itself; their sum has both limits.
double bend_speed(double turn_rad, double bend_length_m, double acceleration, double tolerance_m);

/// How far before its corner the parabola above begins, metres: v·(|Δv|/a)/2 = v²·sin(φ/2)/a.
double turn_distance(double speed_mps, double turn_rad, double acceleration);

/// The velocity, field frame, for the next dt_s: `velocity_mps` is the present one. Comes to rest at the path's end.
/// Works from anywhere, also beside or beyond the path. The path must have a point, all numbers must be finite. The
/// result is no faster than limits.speed_max_mps, but only motion_limits.h makes it reachable within dt_s.
Vec2 follow_path(std::span<const Vec2> path, const Vec2& position_m, const Vec2& velocity_mps,
                 const RobotLimits& limits, const FollowerParams& params, double dt_s);

}  // namespace regista
