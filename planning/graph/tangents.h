// Common tangents of two bodies, as legs of a path that goes round both.
#pragma once

#include <bit>
#include <experimental/simd>
#include <limits>

#include "planning/graph/body.h"

namespace regista::graph {

/// A straight leg from one boundary to another, touching both.
struct Tangent {
  Place from;
  Place to;
  Vec2 along = Vec2::Zero();  ///< unit
  double length_m = 0.0;
};

/// A point as a body.
inline Body body_of(const Vec2& point) {
  Body body;
  body.corners[0] = point;
  body.count = 1;
  body.period = 4.0;
  return body;
}

/// Where legs may leave a disc: from one normal on to another, gone round on a side, at most half way round. Nothing
/// narrow allows all.
struct Departures {
  bool is_narrow = false;
  double side = 1.0;
  Vec2 begin = Vec2::Zero();
  Vec2 end = Vec2::Zero();

  /// `normal` may have any length `scale`.
  bool allow(const Vec2& normal, double scale) const {
    constexpr double kRounding = 1e-8;
    const unsigned is_after_begin = side * cross(begin, normal) >= -kRounding * scale;
    const unsigned is_before_end = side * cross(normal, end) >= -kRounding * scale;
    return (static_cast<unsigned>(!is_narrow) | (is_after_begin & is_before_end)) != 0;
  }

  /// The same for several.
  template <class Lanes>
  typename Lanes::mask_type allow(const Lanes& x, const Lanes& y, double scale) const {
    constexpr double kRounding = 1e-8;
    const Lanes after_begin = side * (begin.x() * y - begin.y() * x);
    const Lanes before_end = side * (x * end.y() - y * end.x());
    const Lanes least = is_narrow ? -kRounding * scale : -std::numeric_limits<double>::infinity();
    return after_begin >= least && before_end >= least;
  }
};

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

/// The same for two discs that do not touch, to both sides of `to` at once: visit(tangent, is_second), first for side
/// -1. False, and nothing is visited: they touch.
template <class Visit>
bool for_disc_tangents(const Body& from, double from_side, const Body& to, const Departures& departures, Visit&& visit);

// ---------------------------------------------------------------------------------------------------------------------

/// Overlapping by this little counts as touching. Metres.
inline constexpr double kTangentTouch_m = 1e-9;

/// No corner lies farther out than the touched one, but for rounding.
inline bool supports(const Body& body, std::uint32_t corner, const Vec2& normal) {
  constexpr double kRounding_m = 1e-10;
  for (std::uint32_t k = 0; k < body.count; ++k) {
    if ((body.corners[k] - body.corners[corner]).dot(normal) > kRounding_m) return false;
  }
  return true;
}

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
  const double m = to.radius_m * to_side - from.radius_m * from_side;
  const bool to_many = to.count > 1;
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

template <class Visit>
bool for_disc_tangents(const Body& from, double from_side, const Body& to, const Departures& departures,
                       Visit&& visit) {
  using Pair = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, 2>>;
  static constexpr std::array kSides{-1.0, 1.0};
  const Pair m =
      to.radius_m * Pair(kSides.data(), std::experimental::element_aligned) - Pair(from.radius_m * from_side);
  const Vec2 d = to.corners[0] - from.corners[0];
  const double distance2 = d.squaredNorm();
  const Pair length2 = distance2 - m * m;
  const Pair touch2 = 2.0 * kTangentTouch_m * std::experimental::abs(m);
  if (any_of(std::experimental::abs(length2) <= touch2) || distance2 == 0.0) return false;
  const Pair length = std::experimental::sqrt(std::experimental::max(length2, Pair(0.0)));
  const Pair scaled_x = m * d.x() - length * d.y();
  const Pair scaled_y = m * d.y() + length * d.x();
  const auto visited = (length2 > 0.0) && departures.allow(-from_side * scaled_x, -from_side * scaled_y, distance2);
  for (const std::size_t i : {0U, 1U}) {
    if (!visited[i]) continue;
    const Vec2 across = Vec2(scaled_x[i], scaled_y[i]) / distance2;
    visit(Tangent{place_on_arc(from, 0, -from_side * across),
                  place_on_arc(to, 0, -kSides[i] * across),
                  {across.y(), -across.x()},
                  length[i]},
          i == 1);
  }
  return true;
}

}  // namespace regista::graph
