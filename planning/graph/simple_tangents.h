// Common tangents where it is plain at which corners they touch, as it mostly is: what most of them cost.
#pragma once

#include <array>
#include <cmath>
#include <experimental/simd>

#include "planning/graph/tangent.h"

namespace regista::graph {

/// From one disc or point to another, to both sides of `to` at once: visit(tangent, is_second), first for side -1.
/// False, and nothing is visited: they touch.
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

/// No leg between both has length zero, and there is exactly one for each pair of sides.
inline bool are_apart(const Body& many, const Body& round) {
  const Vec2& centre = round.corners[0];
  const Vec2 nearest = many.count == 2 ? nearest_on_segment(centre, many.corners[0], many.corners[1])
                                       : Vec2(centre.cwiseMax(many.corners[0]).cwiseMin(many.corners[2]));
  const double radius_m = many.radius_m + round.radius_m + 2.0 * kTangentTouch_m;
  return (nearest - centre).squaredNorm() > radius_m * radius_m;
}

/// The corner of `many` seen farthest to the right (view 1) or left (-1) of that point.
inline std::uint32_t outermost_corner(const Body& many, double view, const Vec2& from) {
  std::uint32_t corner = 0;
  for (std::uint32_t k = 1; k < many.count; ++k) {
    if (view * cross(many.corners[corner] - from, many.corners[k] - from) < 0.0) corner = k;
  }
  return corner;
}

/// Between a capsule or rectangle and a disc or point: visit(tangent). False, and nothing is visited: they are not
/// apart, or not the outermost corner is touched, as it mostly is.
template <class Visit>
bool for_simple_tangent(const Body& from, double from_side, const Body& to, double to_side,
                        const Departures& departures, Visit&& visit) {
  const bool to_many = to.count > 1;
  const Body& many = to_many ? to : from;
  const Body& round = to_many ? from : to;
  if (round.count != 1 || !are_apart(many, round)) return false;
  const std::uint32_t corner = outermost_corner(many, to_many ? to_side : -from_side, round.corners[0]);
  const std::uint32_t i = to_many ? 0 : corner;
  const std::uint32_t j = to_many ? corner : 0;
  const double m = to.radius_m * to_side - from.radius_m * from_side;
  const Vec2 d = to.corners[j] - from.corners[i];
  const double distance2 = d.squaredNorm();
  const double length2 = distance2 - m * m;
  if (!(length2 > 0.0)) return false;  // rounding, far out
  const double length_m = std::sqrt(length2);
  const Vec2 scaled = length_m * Vec2(-d.y(), d.x()) + m * d;
  const Vec2 across = scaled / distance2;
  if (!supports(many, corner, -(to_many ? to_side : from_side) * across)) return false;
  if (!departures.allow(-from_side * scaled, distance2)) return true;
  visit(Tangent{place_on_arc(from, i, -from_side * across),
                place_on_arc(to, j, -to_side * across),
                {across.y(), -across.x()},
                length_m});
  return true;
}

}  // namespace regista::graph
