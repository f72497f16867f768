// Common tangents of two bodies, as legs of a path that goes round both.
#pragma once

#include <bit>

#include "planning/graph/simple_tangents.h"

namespace regista::graph {

/// Calls visit(tangent) for each leg that leaves `from`, gone round on
/// from_side, and arrives at `to`, gone round on to_side: one where the bodies
/// are apart, more or none where they overlap. Sides are 1 (counter-clockwise)
/// or -1; for a point the side means nothing.
///
/// With t the leg's direction and J a quarter turn left, the path touches at
/// corner + radius·n with n = -side·J t, so d = L t + (r₂s₂ - r₁s₁) J t for d
/// from corner to corner, which gives L and t.
template <class Visit>
void for_tangents(const Body& from, double from_side, const Body& to, double to_side, const Departures& departures,
                  Visit&& visit);

// ---------------------------------------------------------------------------------------------------------------------

/// Where a touch lies beyond the end of the corner's arc by less than kTouch_m
/// can tell: that end; else what it was.
inline Vec2 onto_arc(const Body& body, std::uint32_t corner, const Vec2& normal) {
  constexpr double kNearlyParallel = 1.0 - 1e-6;
  if (body.count == 1 || supports(body, corner, normal)) return normal;
  for (const std::uint32_t end : {corner, (corner + 1) % body.count}) {
    if (body.begin_normals[end].dot(normal) > kNearlyParallel) return body.begin_normals[end];
  }
  return normal;
}

/// The corners of a capsule or rectangle, gone round on `side`, at which a leg to or from that corner of another body
/// may touch, as bits; hardly ever more than one where they are apart. `m` as above.
std::uint32_t leading_corners(const Body& many, double side, const Vec2& other, bool is_to, double m);

template <class Visit>
void for_tangents(const Body& from, double from_side, const Body& to, double to_side, const Departures& departures,
                  Visit&& visit) {
  const bool to_many = to.count > 1;
  if ((to_many || from.count > 1) && for_simple_tangent(from, from_side, to, to_side, departures, visit)) return;
  const double m = to.radius_m * to_side - from.radius_m * from_side;
  const auto visit_corners = [&](std::uint32_t i, std::uint32_t j) {
    const Vec2 d = to.corners[j] - from.corners[i];
    const double distance2 = d.squaredNorm();
    const double length2 = distance2 - m * m;
    const double touch2 = 2.0 * kTangentTouch_m * std::abs(m);
    if (length2 < -touch2 || distance2 == 0.0) return;
    // Where the ends touch, the root of what is rounding would be a leg.
    const bool touches = length2 <= touch2;
    const double length_m = touches ? 0.0 : std::sqrt(length2);
    // J t, times d²; and from it both normals.
    const Vec2 scaled = length_m * Vec2(-d.y(), d.x()) + m * d;
    if (!departures.allow(-from_side * scaled, distance2)) return;
    const Vec2 across = touches ? Vec2(d * std::copysign(1.0 / std::sqrt(distance2), m)) : Vec2(scaled / distance2);
    Vec2 from_normal = -from_side * across;
    Vec2 to_normal = -to_side * across;
    double leg_m = length_m;
    if (touches && (from.count > 1 || to.count > 1)) {
      from_normal = onto_arc(from, i, from_normal);
      to_normal = onto_arc(to, j, to_normal);
      leg_m = (d + to.radius_m * to_normal - from.radius_m * from_normal).norm();
    }
    // Where ends touch, a leading corner is one to look closer at; else it has been looked at.
    if (from.count > 1 && (touches || to_many) && !supports(from, i, from_normal)) return;
    if (to.count > 1 && touches && !supports(to, j, to_normal)) return;
    visit(
        Tangent{place_on_arc(from, i, from_normal), place_on_arc(to, j, to_normal), {across.y(), -across.x()}, leg_m});
  };
  const Body& many = to_many ? to : from;
  const Body& one = to_many ? from : to;
  for (std::uint32_t i = 0; i < one.count; ++i) {
    std::uint32_t corners =
        many.count <= 1 ? many.count : leading_corners(many, to_many ? to_side : from_side, one.corners[i], to_many, m);
    for (; corners != 0; corners &= corners - 1) {
      const auto k = static_cast<std::uint32_t>(std::countr_zero(corners));
      visit_corners(to_many ? i : k, to_many ? k : i);
    }
  }
}

}  // namespace regista::graph
