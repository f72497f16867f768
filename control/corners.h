// How fast a path's corners can be driven, from what acceleration and tolerance allow.
#pragma once

#include <span>

#include "control/control_params.h"
#include "control/path_legs.h"

namespace regista {

/// Of the possible change of velocity, how much may go into motion across the path at the speed wanted.
inline constexpr double kAcrossShare = 0.9;

/// The largest speed, m/s, at which a bend of turn_rad in [0, π], spread over bend_length_m of the path, is driven at
/// most tolerance_m beside its vertices: √(acceleration·ρ). Infinite for no bend.
///
/// Derivation: from velocity v·d1 to v·d2 under constant acceleration a takes |Δv|/a with |Δv| = 2·v·sin(φ/2); that
/// parabola passes a corner at |Δv|²/(8a) = v²·sin²(φ/2)/(2a), so ρ = 2·tolerance/sin²(φ/2). A bend spread over a
/// length ℓ can instead be followed with its own radius ℓ/φ; the larger radius counts.
double bend_speed(double turn_rad, double bend_length_m, double acceleration, double tolerance_m);

/// The speed for the corner at the end of the first of these legs, together with the bends soon after it: an arc drawn
/// as a polyline turns but a little at each vertex. Between the least corner speed and the limit, which is above all.
double corner_speed(std::span<const Leg> legs, const RobotLimits& limits, const FollowerParams& params);

}  // namespace regista
