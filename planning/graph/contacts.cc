#include "planning/graph/contacts.h"

#include <algorithm>

#include "planning/graph/samples.h"
#include "planning/outline.h"

namespace regista::graph {
namespace {

/// A point counts as lying on a boundary. Metres.
constexpr double kOn_m = 1e-8;

/// The order of a contact. At a corner without radius, whose arc is one point,
/// the middle of that arc.
double contact_order(const Body& body, const Vec2& point) {
  for (std::uint32_t i = 0; body.radius_m == 0.0 && i < body.count; ++i) {
    if ((point - body.corners[i]).norm() <= kOn_m) return 2.0 * i + 0.5;
  }
  return order_of(body, point);
}

/// A stretch that begins or ends there spares all of that arc: who arrives
/// anywhere on it has not passed the point.
bool is_bare_corner(const Body& body, double order) {
  return body.radius_m == 0.0 && static_cast<std::uint32_t>(order) % 2 == 0;
}

/// How far the obstacle reaches over the bounds; negative when it stays within.
double over_bounds(const Obstacle& obstacle, const Bounds& bounds) {
  return (obstacle.a.cwiseAbs().cwiseMax(obstacle.b.cwiseAbs()) - bounds.half_extent_m).maxCoeff() + obstacle.radius_m;
}

}  // namespace

void Contacts::reset(std::size_t obstacles) {
  ranges_.assign(obstacles, Range{});
  cuts_.clear();
  brushes_.clear();
}

Contacts::Of Contacts::of(const ObstacleField& field, ObstacleIndex obstacle, const Body& body) {
  if (!ranges_[obstacle].is_known) find(field, obstacle, body);
  const Range& range = ranges_[obstacle];
  return {{cuts_.data() + range.cuts_begin, cuts_.data() + range.cuts_end},
          {brushes_.data() + range.brushes_begin, brushes_.data() + range.brushes_end}};
}

void Contacts::find(const ObstacleField& field, ObstacleIndex index, const Body& body) {
  Range range;
  range.cuts_begin = static_cast<std::uint32_t>(cuts_.size());
  range.brushes_begin = static_cast<std::uint32_t>(brushes_.size());
  const Obstacle& obstacle = field.obstacles()[index];
  const double brush_m = kArcOvershoot * obstacle.radius_m;
  near_.clear();
  field.visit_maybe_near(index, brush_m, [this](ObstacleIndex i) { near_.push_back(i); });
  std::sort(near_.begin(), near_.end());
  for (const ObstacleIndex other : near_) {
    const Obstacle& neighbour = field.obstacles()[other];
    const double gap_m = gap(obstacle, neighbour);
    if (gap_m >= brush_m) continue;
    if (gap_m > -kTouch_m) {
      brushes_.push_back(other);
    } else if (surely_holds(obstacle, neighbour)) {
      continue;
    } else if (body.count == 1 && neighbour.core == Core::point) {
      add_disc(obstacle, neighbour, other);
    } else {
      add_outline(obstacle, body, neighbour, other);
    }
  }
  const double over_m = over_bounds(obstacle, field.bounds());
  if (over_m > kTouch_m) add_bounds(obstacle, body, field.bounds());
  if (over_m > -brush_m) brushes_.push_back(kBounds);
  range.cuts_end = static_cast<std::uint32_t>(cuts_.size());
  range.brushes_end = static_cast<std::uint32_t>(brushes_.size());
  range.is_known = true;
  ranges_[index] = range;
}

/// Two circles meet where the line of centres, turned by the angle with cosine
/// (d² + r₁² - r₂²)/(2 d r₁), leaves one.
void Contacts::add_disc(const Obstacle& disc, const Obstacle& other, ObstacleIndex index) {
  const Vec2 between = other.a - disc.a;
  const double distance = between.norm();
  if (distance <= other.radius_m - disc.radius_m - kTouch_m) {
    cuts_.push_back({0.0, 0.0, index, true});
    return;
  }
  if (distance <= std::abs(disc.radius_m - other.radius_m) + kTouch_m) return;  // the other lies inside, or is the same
  const double r = disc.radius_m;
  const double cosine = (distance * distance + r * r - other.radius_m * other.radius_m) / (2.0 * distance * r);
  const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
  const Vec2 along = between * (cosine / distance);
  const Vec2 across = Vec2(-between.y(), between.x()) * (sine / distance);
  Body body;
  body.corners[0] = disc.a;
  body.count = 1;
  body.radius_m = r;
  cuts_.push_back({order_of(body, place_on_arc(body, 0, along - across)),
                   order_of(body, place_on_arc(body, 0, along + across)), index, false});
}

void Contacts::add_outline(const Obstacle& obstacle, const Body& body, const Obstacle& other, ObstacleIndex index) {
  points_.clear();
  append_intersections(outline_of(obstacle), outline_of(other), points_);
  // Outlines hold more than the boundary.
  std::erase_if(points_, [&](const Vec2& point) {
    return std::abs(clearance(point, obstacle)) > kOn_m || std::abs(clearance(point, other)) > kOn_m;
  });
  add_cuts(body, index, [&](const Vec2& point) { return !is_free(point, other); });
}

void Contacts::add_bounds(const Obstacle& obstacle, const Body& body, const Bounds& bounds) {
  points_.clear();
  append_intersections(outline_of(obstacle), outline_of(bounds), points_);
  std::erase_if(points_, [&](const Vec2& point) { return std::abs(clearance(point, obstacle)) > kOn_m; });
  add_cuts(body, kBounds, [&](const Vec2& point) { return !is_inside(point, bounds); });
}

/// Between two neighbouring points_ the boundary is either inside or not: its
/// middle tells.
template <class IsCovered>
void Contacts::add_cuts(const Body& body, ObstacleIndex index, const IsCovered& is_covered) {
  orders_.clear();
  for (const Vec2& point : points_) orders_.push_back(contact_order(body, point));
  std::sort(orders_.begin(), orders_.end());
  if (orders_.empty()) {
    if (is_covered(point_between(body, 0.0, 0.5))) cuts_.push_back({0.0, 0.0, index, true});
    return;
  }
  for (std::size_t i = 0; i < orders_.size(); ++i) {
    const double from = orders_[i];
    const double to = orders_[(i + 1) % orders_.size()];
    const bool goes_round = i + 1 == orders_.size();
    if (from == to && !goes_round) continue;
    // A single point: the whole way round back to it.
    const Vec2 middle = from == to ? point_between(body, 0.0, 0.5) : point_between(body, from, to);
    if (!is_covered(middle)) continue;
    cuts_.push_back(
        {is_bare_corner(body, from) ? from + 0.5 : from, is_bare_corner(body, to) ? to - 0.5 : to, index, from == to});
  }
}

}  // namespace regista::graph
