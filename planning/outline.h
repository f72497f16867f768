// Boundaries as circles and straight sides, and where they meet: what goal_adjustment chooses its candidates from.
// Outlines may contain more than the boundary (whole circles for rounded corners); who uses a point of one checks it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "planning/obstacle_field.h"

namespace regista {

struct Circle {
  Vec2 centre = Vec2::Zero();
  double radius_m = 0.0;
};

struct Side {
  Vec2 a = Vec2::Zero();
  Vec2 b = Vec2::Zero();
};

struct Outline {
  std::array<Circle, 4> circle_store;
  std::array<Side, 4> side_store;
  std::size_t circle_count = 0;
  std::size_t side_count = 0;
  std::span<const Circle> circles() const { return {circle_store.data(), circle_count}; }
  std::span<const Side> sides() const { return {side_store.data(), side_count}; }
};

Outline outline_of(const Obstacle& obstacle);
Outline outline_of(const Bounds& bounds);

/// The sides through which a straight leg from a point outside comes into the bounds: one or two; none for a point
/// inside.
Outline entry_of(const Bounds& bounds, const Vec2& point);

/// No point of the outline is farther from `point`. Metres.
double farthest_m(const Vec2& point, const Outline& outline);

/// Appends, for each circle and side, the point nearest to `point`; for a circle around `point` itself four of them.
void append_projections(const Vec2& point, const Outline& outline, std::vector<Vec2>& out);

/// Appends all points that both outlines have in common (any of them, where a stretch is common).
void append_intersections(const Outline& one, const Outline& other, std::vector<Vec2>& out);

/// The straight rays from `point` that touch the outline's circles, each `length_m` long, without circles of its own.
void append_tangents(const Vec2& point, const Outline& outline, double length_m, std::vector<Outline>& out);

}  // namespace regista
