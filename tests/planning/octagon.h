// An octagon by its definition as a hull, which DVG's own is held against.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "world_model/types/geometry.h"

namespace regista::testing {

/// The k-th of so many unit vectors all around.
inline Vec2 direction(int k, int of) {
  const double angle_rad = 2.0 * std::numbers::pi * k / of;
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

/// How deep the point lies within the octagon, metres; by its definition as a hull, not by its normals.
inline double depth(const Vec2& point, const Vec2& centre, double radius_m) {
  double least = radius_m;
  for (int k = 0; k < 8; ++k) {
    const Vec2 a = centre + radius_m * direction(k, 8);
    const Vec2 b = centre + radius_m * direction(k + 1, 8);
    least = std::min(least, cross((b - a).normalized(), point - a));
  }
  return least;
}

}  // namespace regista::testing
