// The least time in which a point mass whose acceleration is bounded by a disc comes to rest at the origin: what the
// bench of free motion compares with, independent of everything in control/.
//
// Pontryagin's principle for x' = v, v' = u, |u| <= a: u points along λ(t) = λ(0) − p·t, so its direction follows the
// linear tangent law (Bryson & Ho, "Applied Optimal Control", 2.4). The system is linear and the bound convex, so an
// extremal that ends at rest is the optimum; that λ also proves it, see shortfall().
#pragma once

#include "world_model/types/geometry.h"

namespace regista::bench {

struct MinimumTime {
  double duration_s = 0.0;
  Vec2 costate_begin = Vec2::Zero();  ///< λ(0); u = a · λ/|λ|
  Vec2 costate_end = Vec2::Zero();    ///< λ(duration_s)
};

/// From position x, m, and velocity v, m/s, to rest at the origin with |acceleration| <= a, m/s². Throws
/// std::invalid_argument for a <= 0 or numbers that are not finite, std::runtime_error with the state where the search
/// finds nothing. So near to a line through the origin that it does not converge, the answer is the line's, whose
/// duration is right to some 1e-3 and whose end is that far off.
MinimumTime minimum_time(const Vec2& x, const Vec2& v, double a);

/// Positive where the costate of `answer` proves that the state cannot come to rest at the origin within time_s:
/// d/dt(λ·v + p·x) = λ·u, so rest needs ∫λ·u = −λ(0)·v − p·x, and no admissible u gives more than a·∫|λ|. This is the
/// need minus the most there is, by plain summation.
double shortfall(const MinimumTime& answer, const Vec2& x, const Vec2& v, double a, double time_s);

}  // namespace regista::bench
