#include "planning/planners/dvg_polygon.h"

#include "planning/clearance.h"

namespace regista::dvg {
namespace {

constexpr double kHalfSqrt2 = std::numbers::sqrt2 / 2.0;
constexpr double kSin = 0.38268343236508977;  // of 22.5°

/// Written out so that mirror images are exact. Side k lies between vertices k and k + 1.
constexpr std::array<std::array<double, 2>, 8> kVertices{{{1.0, 0.0},
                                                          {kHalfSqrt2, kHalfSqrt2},
                                                          {0.0, 1.0},
                                                          {-kHalfSqrt2, kHalfSqrt2},
                                                          {-1.0, 0.0},
                                                          {-kHalfSqrt2, -kHalfSqrt2},
                                                          {0.0, -1.0},
                                                          {kHalfSqrt2, -kHalfSqrt2}}};
constexpr std::array<std::array<double, 2>, 8> kNormals{{{kApothem, kSin},
                                                         {kSin, kApothem},
                                                         {-kSin, kApothem},
                                                         {-kApothem, kSin},
                                                         {-kApothem, -kSin},
                                                         {-kSin, -kApothem},
                                                         {kSin, -kApothem},
                                                         {kApothem, -kSin}}};

/// Vertices stand off by this share more than needed, so that rounding does not put sides inside.
constexpr double kStandOff = 1.0 + 1e-9;

Vec2 vertex(std::size_t k) { return {kVertices[k][0], kVertices[k][1]}; }
Vec2 normal(std::size_t k) { return {kNormals[k][0], kNormals[k][1]}; }

void add(Polygon& polygon, const Vec2& corner) { polygon.store[polygon.count++] = corner; }

/// The octagon swept along the segment: a corner whose sides face forward lies at the far end, one whose sides face
/// backward at the near end, and the two between at both.
Polygon hull(const Obstacle& capsule, double radius_m) {
  Polygon polygon;
  polygon.centre = 0.5 * (capsule.a + capsule.b);
  polygon.is_disc = false;
  const Vec2 along = capsule.b - capsule.a;
  for (std::size_t k = 0; k < kVertices.size(); ++k) {
    const double before = normal((k + 7) % 8).dot(along);
    const double after = normal(k).dot(along);
    if (before < 0.0 || after < 0.0) add(polygon, capsule.a + radius_m * vertex(k));
    if (before > 0.0 || after > 0.0) add(polygon, capsule.b + radius_m * vertex(k));
  }
  return polygon;
}

Polygon corners(const Obstacle& rectangle) {
  Polygon polygon;
  polygon.centre = 0.5 * (rectangle.a + rectangle.b);
  polygon.is_disc = false;
  const Vec2 grow = Vec2::Constant(rectangle.radius_m * kStandOff);
  const Vec2 low = rectangle.a - grow;
  const Vec2 high = rectangle.b + grow;
  for (const Vec2& corner : {low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y())}) add(polygon, corner);
  return polygon;
}

}  // namespace

Polygon octagon(const Vec2& centre, double radius_m) {
  Polygon polygon;
  polygon.centre = centre;
  for (std::size_t k = 0; k < kVertices.size(); ++k) add(polygon, centre + radius_m * vertex(k));
  return polygon;
}

Polygon polygon_around(const Obstacle& obstacle) {
  if (obstacle.core == Core::rectangle) return corners(obstacle);
  const double radius_m = obstacle.radius_m * (kStandOff / kApothem);
  const bool has_length = obstacle.core == Core::segment && obstacle.a != obstacle.b;
  return has_length ? hull(obstacle, radius_m) : octagon(obstacle.a, radius_m);
}

bool crosses_octagon(const Vec2& from, const Vec2& to, const Vec2& centre, double radius_m) {
  const double distance_m = (nearest_on_segment(centre, from, to) - centre).norm();
  const double within_m = radius_m * kApothem;
  if (distance_m >= radius_m) return false;
  if (distance_m < within_m - kTouch_m) return true;
  // Between the two circles: cut the segment (t from 0 to 1) by the eight half planes.
  const Vec2 along = to - from;
  double first = 0.0;
  double last = 1.0;
  for (std::size_t k = 0; k < kNormals.size(); ++k) {
    const double speed = normal(k).dot(along);
    const double room = within_m - kTouch_m - normal(k).dot(from - centre);
    if (speed == 0.0) {
      if (room <= 0.0) return false;
    } else if (speed > 0.0) {
      last = std::min(last, room / speed);
    } else {
      first = std::max(first, room / speed);
    }
  }
  return first < last;
}

}  // namespace regista::dvg
