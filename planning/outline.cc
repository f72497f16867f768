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

/// Boxes around both are apart, by more than what counts as touching below.
bool are_apart(const Vec2& low, const Vec2& high, const Vec2& other_low, const Vec2& other_high) {
  const double margin_m = 1e-4 + 1e-9 * (low.cwiseAbs() + other_low.cwiseAbs()).sum();
  return (low - other_high).cwiseMax(other_low - high).maxCoeff() > margin_m;
}

bool are_apart(const Side& side, const Circle& circle) {
  const Vec2 reach = Vec2::Constant(circle.radius_m);
  return are_apart(side.a.cwiseMin(side.b), side.a.cwiseMax(side.b), circle.centre - reach, circle.centre + reach);
}

bool are_apart(const Side& one, const Side& other) {
  return are_apart(one.a.cwiseMin(one.b), one.a.cwiseMax(one.b), other.a.cwiseMin(other.b), other.a.cwiseMax(other.b));
}

/// Where |from + t·along - centre| = radius, for all t; nearest approach where they miss by rounding alone.
void append_line_circle(const Side& side, const Circle& circle, std::vector<Vec2>& out) {
  if (are_apart(side, circle)) return;
  const Vec2 along = side.b - side.a;
  const double length2 = along.squaredNorm();
  if (length2 == 0.0) return;
  const double foot = (circle.centre - side.a).dot(along) / length2;
  const double distance = cross(along, circle.centre - side.a) / std::sqrt(length2);
  const double half2 = circle.radius_m * circle.radius_m - distance * distance;
  if (half2 < -kTouch_m) return;
  const double half = std::sqrt(std::max(half2, 0.0) / length2);
  for (const double t : {foot - half, foot + half}) {
    if (t >= -kTouch_m && t <= 1.0 + kTouch_m) out.push_back(side.a + t * along);
  }
}

void append_circle_circle(const Circle& one, const Circle& other, std::vector<Vec2>& out) {
  const Vec2 between = other.centre - one.centre;
  const double distance2 = between.squaredNorm();
  if (distance2 == 0.0) return;
  // From one's centre along `between` to the chord: a share; and half the chord, in the same unit.
  const double r2 = one.radius_m * one.radius_m;
  const double along = (distance2 + r2 - other.radius_m * other.radius_m) / (2.0 * distance2);
  const double half2 = r2 / distance2 - along * along;
  if (half2 < -kTouch_m) return;
  const double half = std::sqrt(std::max(half2, 0.0));
  const Vec2 across(-between.y(), between.x());
  out.push_back(one.centre + along * between + half * across);
  out.push_back(one.centre + along * between - half * across);
}

void append_side_side(const Side& one, const Side& other, std::vector<Vec2>& out) {
  if (are_apart(one, other)) return;
  const Vec2 u = one.b - one.a;
  const Vec2 v = other.b - other.a;
  const double determinant = cross(u, v);
  if (determinant == 0.0) {
    // Parallel: where they overlap, an end of one lies on the other.
    for (const Vec2& end : {one.a, one.b, other.a, other.b}) out.push_back(end);
    return;
  }
  const double t = cross(other.a - one.a, v) / determinant;
  const double s = cross(other.a - one.a, u) / determinant;
  const auto within = [](double share) { return share >= -kTouch_m && share <= 1.0 + kTouch_m; };
  if (within(t) && within(s)) out.push_back(one.a + t * u);
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

void append_intersections(const Outline& one, const Outline& other, std::vector<Vec2>& out) {
  for (const Circle& circle : one.circles()) {
    for (const Circle& another : other.circles()) append_circle_circle(circle, another, out);
    for (const Side& side : other.sides()) append_line_circle(side, circle, out);
  }
  for (const Side& side : one.sides()) {
    for (const Circle& circle : other.circles()) append_line_circle(side, circle, out);
    for (const Side& another : other.sides()) append_side_side(side, another, out);
  }
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
