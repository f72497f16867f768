// Where two outlines meet: append_intersections of outline.h.
#include <algorithm>
#include <cmath>

#include "planning/outline.h"

namespace regista {
namespace {

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

}  // namespace regista
