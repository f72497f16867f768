// Objects as polygons, as the dynamic visibility graph has them: "a radius r and an angle θ, which are the radius of
// the circumscribed circle and the angle between each vertex" (Costa & Tonidandel, section 3.1), θ = 45°.
#pragma once

#include <array>
#include <span>

#include "planning/obstacle.h"

namespace regista::dvg {

/// cos(22.5°): the circle within an octagon against the one around it.
inline constexpr double kApothem = 0.92387953251128674;

/// Corners a path may turn at, in no order that means something. The centre is what the edge limit measures from.
struct Polygon {
  Vec2 centre = Vec2::Zero();
  std::array<Vec2, 10> store;
  std::size_t count = 0;
  /// The edge limit holds between objects that are discs. The paper has no others, and says that the limit leaves the
  /// tangents because they have one size; of a long wall it would leave no corner.
  bool is_disc = true;
  std::span<const Vec2> vertices() const { return {store.data(), count}; }
};

/// With vertices at 0°, 45°, … on the circle of that radius.
Polygon octagon(const Vec2& centre, double radius_m);

/// A polygon that holds the obstacle, so that its sides are free as far as this obstacle goes. A disc: the octagon
/// whose sides touch it. A capsule: the hull of such octagons around both ends, ten corners. A rectangle, which the
/// paper does not have: the four corners of the grown rectangle.
Polygon polygon_around(const Obstacle& obstacle);

/// Whether the segment has a point inside octagon(centre, radius_m), its boundary not counted.
bool crosses_octagon(const Vec2& from, const Vec2& to, const Vec2& centre, double radius_m);

}  // namespace regista::dvg
