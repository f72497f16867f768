#include "planning/outline.h"

namespace regista {
namespace {

void add_circle(Outline& outline, const Vec2& centre, double radius_m) {
  outline.circle_store[outline.circle_count++] = {centre, radius_m};
}

void add_side(Outline& outline, const Vec2& a, const Vec2& b) { outline.side_store[outline.side_count++] = {a, b}; }

Outline capsule_outline(const Obstacle& obstacle) {
  Outline outline;
  add_circle(outline, obstacle.a, obstacle.radius_m);
  add_circle(outline, obstacle.b, obstacle.radius_m);
  const Vec2 along = obstacle.b - obstacle.a;
  if (along.squaredNorm() > 0.0) {
    const Vec2 offset = Vec2(-along.y(), along.x()).normalized() * obstacle.radius_m;
    add_side(outline, obstacle.a + offset, obstacle.b + offset);
    add_side(outline, obstacle.a - offset, obstacle.b - offset);
  }
  return outline;
}

Outline rectangle_outline(const Vec2& low, const Vec2& high, double radius_m) {
  Outline outline;
  for (const double x : {low.x(), high.x()}) {
    for (const double y : {low.y(), high.y()}) add_circle(outline, {x, y}, radius_m);
  }
  for (const double x : {low.x() - radius_m, high.x() + radius_m}) add_side(outline, {x, low.y()}, {x, high.y()});
  for (const double y : {low.y() - radius_m, high.y() + radius_m}) add_side(outline, {low.x(), y}, {high.x(), y});
  return outline;
}

}  // namespace

Outline outline_of(const Obstacle& obstacle) {
  switch (obstacle.core) {
    case Core::point: {
      Outline outline;
      add_circle(outline, obstacle.a, obstacle.radius_m);
      return outline;
    }
    case Core::segment:
      return capsule_outline(obstacle);
    case Core::rectangle:
      break;
  }
  return rectangle_outline(obstacle.a, obstacle.b, obstacle.radius_m);
}

Outline outline_of(const Bounds& bounds) { return rectangle_outline(-bounds.half_extent_m, bounds.half_extent_m, 0.0); }

Outline entry_of(const Bounds& bounds, const Vec2& point) {
  Outline entry;
  const Vec2& half = bounds.half_extent_m;
  for (const Eigen::Index axis : {0, 1}) {
    if (std::abs(point[axis]) <= half[axis] + kTouch_m) continue;
    Vec2 end = half;
    end[axis] = std::copysign(half[axis], point[axis]);
    Vec2 other_end = end;
    other_end[1 - axis] = -half[1 - axis];
    add_side(entry, other_end, end);
  }
  return entry;
}

double farthest_m(const Vec2& point, const Outline& outline) {
  double farthest_m = 0.0;
  for (const Circle& circle : outline.circles()) {
    farthest_m = std::max(farthest_m, (circle.centre - point).norm() + circle.radius_m);
  }
  for (const Side& side : outline.sides()) {
    farthest_m = std::max({farthest_m, (side.a - point).norm(), (side.b - point).norm()});
  }
  return farthest_m;
}

void append_projections(const Vec2& point, const Outline& outline, std::vector<Vec2>& out) {
  for (const Circle& circle : outline.circles()) {
    const Vec2 outwards = point - circle.centre;
    const double distance = outwards.norm();
    if (distance > 0.0) {
      out.push_back(circle.centre + outwards * (circle.radius_m / distance));
    } else {
      for (const Vec2& direction : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)}) {
        out.push_back(circle.centre + circle.radius_m * direction);
      }
    }
  }
  for (const Side& side : outline.sides()) out.push_back(nearest_on_segment(point, side.a, side.b));
}

void append_tangents(const Vec2& point, const Outline& outline, double length_m, std::vector<Outline>& out) {
  for (const Circle& circle : outline.circles()) {
    const Vec2 to_centre = circle.centre - point;
    const double distance = to_centre.norm();
    if (distance == 0.0) continue;
    const double angle_rad = std::asin(std::min(1.0, circle.radius_m / distance));
    for (const double turn_rad : {angle_rad, -angle_rad}) {
      Outline ray;
      add_side(ray, point, point + rotated(to_centre, turn_rad) * (length_m / distance));
      out.push_back(ray);
    }
  }
}

}  // namespace regista
