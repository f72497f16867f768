// The least time to rest at the origin under the limits model itself, control/motion_limits.h: half a disc ahead of the
// velocity, half an ellipse, longer by the braking, behind it. For the bench of free motion.
//
// Pontryagin's principle with U(v) turning with v: u maximises λ·u over U(v), λ' = −p − ∂h/∂v with h = max λ·u. Ahead
// (λ·v >= 0) h = a·|λ|; behind, with λ = (l, c) along and across v, h = √(b²l² + a²c²), whose derivative by the angle
// of v is (b² − a²)·l·c/h. Integrated backward from rest, where v = b·τ·e and c = p·n·τ/2: forward it is unstable
// there.
#pragma once

#include <optional>

#include "world_model/types/geometry.h"

namespace regista::bench {

/// Seconds from position x, m, and velocity v, m/s; 0 < a <= b, m/s². Continues the optimum of the disc of radius a
/// until the braking is b; an extremal, so an upper bound whatever else, and where it is unique the optimum. None where
/// the continuation breaks off, as near reversals on a line, where v all but stops on the way. Throws as
/// minimum_time().
std::optional<double> braking_time(const Vec2& x, const Vec2& v, double a, double b);

}  // namespace regista::bench
