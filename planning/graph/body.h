// An obstacle's boundary as a taut path runs along it: corner arcs of one radius joined by straight sides. Places on it
// are in cyclic order; a path goes round it counter-clockwise (side 1) or clockwise (side -1).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "planning/obstacle.h"

namespace regista::graph {

/// A point of a boundary, on the arc of one of its corners.
struct Place {
  Vec2 point = Vec2::Zero();
  Vec2 normal = Vec2::Zero();  ///< unit, outwards
  std::uint32_t corner = 0;
};

struct Body {
  std::array<Vec2, 4> corners;         ///< of the core, counter-clockwise
  std::array<Vec2, 4> begin_normals;   ///< where a corner's arc begins, counter-clockwise; of no meaning for a disc
  std::array<double, 4> side_lengths;  ///< from corner i to the next; metres
  std::uint32_t count = 0;             ///< of corners: 1, 2 or 4; 0 for what has no extent and blocks nothing
  double radius_m = 0.0;
  double period = 0.0;
};

/// A rectangle without width is the capsule of its longer side, a capsule without length a disc.
Body body_of(const Obstacle& obstacle);

/// The corner that lies farthest in direction `normal`.
inline std::uint32_t extreme_corner(const Body& body, const Vec2& normal) {
  if (body.count == 1) return 0;
  if (body.count == 2) return (body.corners[1] - body.corners[0]).dot(normal) >= 0.0 ? 1 : 0;
  // Corner 0 is the lower left one.
  if (normal.y() < 0.0) return normal.x() < 0.0 ? 0 : 1;
  return normal.x() >= 0.0 ? 2 : 3;
}

/// The place on the arc of `corner` with that normal, which must be one of the arc's.
inline Place place_on_arc(const Body& body, std::uint32_t corner, const Vec2& normal) {
  return {body.corners[corner] + body.radius_m * normal, normal, corner};
}

/// The order of boundary points: grows counter-clockwise in [0, Body::period); only comparisons mean something.
double order_of(const Body& body, const Place& place);

/// The normal of a disc at that order.
Vec2 disc_normal(double order);

/// The same for any point that lies on the boundary (to rounding), sides included.
double order_of(const Body& body, const Vec2& point);

/// The boundary's point half way, in order, counter-clockwise from one to the other.
Vec2 point_between(const Body& body, double from_order, double to_order);

/// How far `to` lies ahead of `from` in order, going round on that side; in [0, period). Behind by rounding is 0.
inline double ahead(const Body& body, double from, double to, double side) {
  double distance = side * (to - from);
  if (distance < 0.0) distance += body.period;
  constexpr double kRounding = 1e-9;
  return distance >= body.period - kRounding ? 0.0 : distance;
}

/// Length of the boundary from one place, each on an arc, to the other, going round on that side. Metres.
double travel_m(const Body& body, const Place& from, const Place& to, double side);

}  // namespace regista::graph
