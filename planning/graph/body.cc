#include "planning/graph/body.h"

#include "planning/graph/turn.h"

namespace regista::graph {
namespace {

Vec2 turned_left(const Vec2& v) { return {-v.y(), v.x()}; }
Vec2 turned_right(const Vec2& v) { return {v.y(), -v.x()}; }

/// Grows with the angle from (1, 0), from 0 to 4: the place on the square |x| +
/// |y| = 1.
double diamond(double x, double y) {
  const double share = y / (std::abs(x) + std::abs(y));
  if (x < 0.0) return 2.0 - share;
  return share < 0.0 ? 4.0 + share : share;
}

/// diamond() backwards, as a unit vector.
Vec2 from_diamond(double d) {
  const double x = d <= 2.0 ? 1.0 - d : d - 3.0;
  const double y = d <= 1.0 ? d : d <= 3.0 ? 2.0 - d : d - 4.0;
  return Vec2(x, y).normalized();
}

void set_corners(Body& body, std::initializer_list<Vec2> corners) {
  body.count = 0;
  for (const Vec2& corner : corners) body.corners[body.count++] = corner;
  for (std::uint32_t i = 0; i < body.count; ++i) {
    const std::uint32_t next = (i + 1) % body.count;
    const Vec2 side = body.corners[next] - body.corners[i];
    body.side_lengths[i] = side.norm();
    if (body.count > 1) body.begin_normals[next] = turned_right(side) / body.side_lengths[i];
  }
  body.period = body.count == 1 ? 4.0 : 2.0 * body.count;
}

/// Place within a corner's arc, from 0 to 1.
double share_of_arc(const Body& body, std::uint32_t corner, const Vec2& normal) {
  const Vec2& begin = body.begin_normals[corner];
  const double p = normal.dot(begin);
  const double q = cross(begin, normal);
  const double share = std::max(q, 0.0) == 0.0 && p >= 0.0 ? 0.0 : diamond(p, std::max(q, 0.0));
  return body.count == 2 ? 0.5 * share : std::min(share, 1.0);
}

}  // namespace

Body body_of(const Obstacle& obstacle) {
  Body body;
  body.radius_m = obstacle.radius_m;
  const Vec2& a = obstacle.a;
  const Vec2& b = obstacle.b;
  if (obstacle.core == Core::point || a == b) {
    set_corners(body, {a});
  } else if (obstacle.core == Core::segment || a.x() == b.x() || a.y() == b.y()) {
    set_corners(body, {a, b});
  } else {
    set_corners(body, {a, {b.x(), a.y()}, b, {a.x(), b.y()}});
    return body;
  }
  if (body.radius_m == 0.0) body.count = 0;
  return body;
}

double order_of(const Body& body, const Place& place) {
  if (body.count == 1) return diamond(place.normal.x(), place.normal.y());
  return 2.0 * place.corner + share_of_arc(body, place.corner, place.normal);
}

Vec2 disc_normal(double order) {
  const double rest = std::fmod(order, 4.0);
  return from_diamond(rest < 0.0 ? rest + 4.0 : rest);
}

double order_of(const Body& body, const Vec2& point) {
  // Nearest point of the core: on a side where the foot lies within it, else a
  // corner.
  for (std::uint32_t i = 0; body.count > 1 && i < body.count; ++i) {
    const Vec2& normal = body.begin_normals[(i + 1) % body.count];
    const Vec2 from_corner = point - body.corners[i];
    const double along = from_corner.dot(turned_left(normal)) / body.side_lengths[i];
    constexpr double kRounding_m = 1e-6;
    if (along <= 0.0 || along >= 1.0 || from_corner.dot(normal) < body.radius_m - kRounding_m) continue;
    return 2.0 * i + 1.0 + along;
  }
  std::uint32_t nearest = 0;
  for (std::uint32_t i = 1; i < body.count; ++i) {
    if ((point - body.corners[i]).squaredNorm() < (point - body.corners[nearest]).squaredNorm()) nearest = i;
  }
  const Vec2 outwards = point - body.corners[nearest];
  const double distance = outwards.norm();
  return order_of(body, {point, distance > 0.0 ? Vec2(outwards / distance) : Vec2(1.0, 0.0), nearest});
}

Vec2 point_between(const Body& body, double from_order, double to_order) {
  double order = from_order + 0.5 * ahead(body, from_order, to_order, 1.0);
  if (order >= body.period) order -= body.period;
  if (body.count == 1) return place_on_arc(body, 0, from_diamond(order)).point;
  const auto piece = static_cast<std::uint32_t>(order);
  const std::uint32_t corner = piece / 2;
  const double share = order - piece;
  if (piece % 2 == 0) {
    const Vec2 local = from_diamond(body.count == 2 ? 2.0 * share : share);
    const Vec2& begin = body.begin_normals[corner];
    return place_on_arc(body, corner, local.x() * begin + local.y() * turned_left(begin)).point;
  }
  const std::uint32_t next = (corner + 1) % body.count;
  const Vec2 foot = body.corners[corner] + share * (body.corners[next] - body.corners[corner]);
  return foot + body.radius_m * body.begin_normals[next];
}

double travel_m(const Body& body, const Place& from, const Place& to, double side) {
  double turn_rad = turn(from.normal, to.normal, side);
  if (body.count == 1) return body.radius_m * turn_rad;
  // More than half way round on a turn of nothing: along a side, all of it but
  // the side by rounding. Half way round a capsule's end and half way round all
  // but that end are the same turn: the order tells.
  const auto is_far = [&] { return ahead(body, order_of(body, from), order_of(body, to), side) > 0.5 * body.period; };
  if (turn_rad < kNoTurn_rad && is_far()) turn_rad += 2.0 * std::numbers::pi;
  double length_m = body.radius_m * turn_rad;
  // Sides are passed from corner to corner; on one corner's arc backwards, all
  // of them.
  const bool is_forwards = side > 0.0;
  std::uint32_t corner = is_forwards ? from.corner : to.corner;
  const std::uint32_t last = is_forwards ? to.corner : from.corner;
  const bool goes_all_round = corner == last && turn_rad > 1.0 && is_far();
  if (goes_all_round || corner != last) {
    do {
      length_m += body.side_lengths[corner];
      corner = (corner + 1) % body.count;
    } while (corner != last);
  }
  return length_m;
}

}  // namespace regista::graph
