// How far a point or a straight motion stays from an obstacle: the only collision truth. Planners, the check of their
// answers, the simulator and the tests all ask these functions; they are exact, nothing is stepped along.
#pragma once

#include "planning/obstacle.h"

namespace regista {

/// Touching is free: rounding of this size is not a collision. Metres.
inline constexpr double kTouch_m = 1e-9;

/// Signed distance in metres from a point to the obstacle's boundary: negative inside, where it is minus the distance
/// to the nearest free point as far as this obstacle alone is concerned. Arguments must be finite.
double clearance(const Vec2& point, const Obstacle& obstacle);

/// Least clearance of all points of the segment from `from` to `to`, both ends included.
double clearance(const Vec2& from, const Vec2& to, const Obstacle& obstacle);

inline bool is_free(const Vec2& point, const Obstacle& obstacle) { return clearance(point, obstacle) >= -kTouch_m; }

/// The same for a disc, without root and quotient: the centre's distance to the segment, squared.
inline bool is_free_of_disc(const Vec2& from, const Vec2& to, const Vec2& centre, double radius_m) {
  const double least_m = std::max(radius_m - kTouch_m, 0.0);
  const Vec2 along = to - from;
  const Vec2 to_centre = centre - from;
  const double foot = to_centre.dot(along);
  if (foot <= 0.0) return to_centre.squaredNorm() >= least_m * least_m;
  const double length2 = along.squaredNorm();
  if (foot >= length2) return (centre - to).squaredNorm() >= least_m * least_m;
  const double across = cross(along, to_centre);
  return across * across >= least_m * least_m * length2;
}

/// The same for a capsule or a rounded rectangle: as soon as something is too near, the least clearance matters no
/// more.
bool is_free_of_extended(const Vec2& from, const Vec2& to, const Obstacle& obstacle);

/// The clearance of the segment is not below -kTouch_m.
inline bool is_free(const Vec2& from, const Vec2& to, const Obstacle& obstacle) {
  if (obstacle.core == Core::point) return is_free_of_disc(from, to, obstacle.a, obstacle.radius_m);
  return is_free_of_extended(from, to, obstacle);
}

}  // namespace regista
