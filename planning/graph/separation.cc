#include "planning/graph/separation.h"

#include <limits>
#include <optional>
#include <utility>

#include "planning/graph/body.h"
#include "planning/graph/samples.h"

namespace regista::graph {
namespace {

/// A core as a convex polygon of one, two or four corners.
struct Polygon {
  std::array<Vec2, 4> corners;
  std::uint32_t count = 0;
  const Vec2& next(std::uint32_t i) const { return corners[(i + 1) % count]; }
};

Polygon core_of(const Obstacle& obstacle) {
  if (obstacle.core == Core::point) return {{obstacle.a}, 1};
  if (obstacle.core == Core::segment) return {{obstacle.a, obstacle.b}, 2};
  const Vec2& a = obstacle.a;
  const Vec2& b = obstacle.b;
  return {{a, {b.x(), a.y()}, b, {a.x(), b.y()}}, 4};
}

Vec2 middle_of(const Obstacle& obstacle) { return 0.5 * (obstacle.a + obstacle.b); }

/// Without, an obstacle forbids nothing.
bool has_extent(const Obstacle& obstacle) {
  return obstacle.radius_m > kTouch_m ||
         (obstacle.core == Core::rectangle && (obstacle.b - obstacle.a).minCoeff() > 2.0 * kTouch_m);
}

bool holds(const Obstacle& obstacle, const Vec2& point) {
  return obstacle.core == Core::rectangle && (point.array() >= obstacle.a.array()).all() &&
         (point.array() <= obstacle.b.array()).all();
}

/// Where two segments cross, if they do.
std::optional<Vec2> crossing(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Vec2 u = b - a;
  const Vec2 v = d - c;
  const double determinant = cross(u, v);
  if (determinant == 0.0) return std::nullopt;
  const double t = cross(c - a, v) / determinant;
  const double s = cross(c - a, u) / determinant;
  if (t < 0.0 || t > 1.0 || s < 0.0 || s > 1.0) return std::nullopt;
  return Vec2(a + t * u);
}

/// A point of each core, nearest to each other.
std::pair<Vec2, Vec2> nearest_points(const Obstacle& one, const Obstacle& other) {
  const Polygon p = core_of(one);
  const Polygon q = core_of(other);
  std::pair<Vec2, Vec2> best{p.corners[0], q.corners[0]};
  double best2 = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Vec2& a, const Vec2& b) {
    const double distance2 = (a - b).squaredNorm();
    if (distance2 >= best2) return;
    best2 = distance2;
    best = {a, b};
  };
  for (std::uint32_t i = 0; i < p.count; ++i) {
    if (holds(other, p.corners[i])) offer(p.corners[i], p.corners[i]);
    for (std::uint32_t j = 0; j < q.count; ++j) {
      offer(p.corners[i], nearest_on_segment(p.corners[i], q.corners[j], q.next(j)));
      offer(nearest_on_segment(q.corners[j], p.corners[i], p.next(i)), q.corners[j]);
      if (const auto common = crossing(p.corners[i], p.next(i), q.corners[j], q.next(j))) offer(*common, *common);
    }
  }
  for (std::uint32_t j = 0; j < q.count; ++j) {
    if (holds(one, q.corners[j])) offer(q.corners[j], q.corners[j]);
  }
  return best;
}

/// On one side at least the obstacle overlaps the outside of the bounds.
bool reaches_out(const Obstacle& obstacle, const Bounds& bounds) {
  const Vec2 farthest = obstacle.a.cwiseAbs().cwiseMax(obstacle.b.cwiseAbs());
  return (farthest.array() + obstacle.radius_m > bounds.half_extent_m.array() + kTouch_m).any();
}

}  // namespace

void append_overlaps(const ObstacleField& field, std::vector<Overlap>& out) {
  for (ObstacleIndex i = 0; i < field.size(); ++i) {
    const Obstacle& one = field.obstacles()[i];
    if (!has_extent(one)) continue;
    field.visit_maybe_near(i, 0.0, [&](ObstacleIndex j) {
      const Obstacle& other = field.obstacles()[j];
      if (j < i || !has_extent(other) || gap(one, other) >= -kTouch_m) return;
      const auto [from, to] = nearest_points(one, other);
      out.push_back({i, j, from, to});
    });
  }
}

bool Separation::separates(const ObstacleField& field, std::span<const Overlap> overlaps, const Vec2& start,
                           const Vec2& goal, std::span<const std::size_t> ignored) {
  start_ = start;
  along_ = goal - start;
  members_.resize(field.size() + 1);
  for (ObstacleIndex i = 0; i < members_.size(); ++i) members_[i] = {i, 0};
  for (ObstacleIndex i = 0; i < field.size(); ++i) {
    const Obstacle& obstacle = field.obstacles()[i];
    if (!reaches_out(obstacle, field.bounds()) || is_ignored(i, ignored) || !has_extent(obstacle)) continue;
    if (meets_bounds(field, i)) return true;
  }
  for (const Overlap& overlap : overlaps) {
    if (is_ignored(overlap.one, ignored) || is_ignored(overlap.other, ignored)) continue;
    const Vec2 one = middle_of(field.obstacles()[overlap.one]);
    const Vec2 other = middle_of(field.obstacles()[overlap.other]);
    const int along = crossings(one, overlap.from) + crossings(overlap.from, overlap.to) + crossings(overlap.to, other);
    if (closes(overlap.one, overlap.other, along)) return true;
  }
  return false;
}

/// How often a way crosses the segment from start to goal from right to left, less the other way round.
int Separation::crossings(const Vec2& from, const Vec2& to) const {
  const double from_side = cross(along_, from - start_);
  const double to_side = cross(along_, to - start_);
  if ((from_side < 0.0) == (to_side < 0.0)) return 0;
  const Vec2 meeting = from + (to - from) * (from_side / (from_side - to_side));
  const double share = (meeting - start_).dot(along_);
  if (share < 0.0 || share > along_.squaredNorm()) return 0;
  return from_side < 0.0 ? 1 : -1;
}

Separation::Member Separation::root_of(ObstacleIndex member) {
  int sum = 0;
  while (members_[member].parent != member) {
    // Halving: every second one is hung one higher.
    Member& here = members_[member];
    const Member& above = members_[here.parent];
    if (above.parent != here.parent) here = {above.parent, here.crossings + above.crossings};
    sum += here.crossings;
    member = here.parent;
  }
  return {member, sum};
}

/// Joins two that overlap; true when they were joined already and the curve through both separates.
bool Separation::closes(ObstacleIndex one, ObstacleIndex other, int crossings) {
  const Member a = root_of(one);
  const Member b = root_of(other);
  if (a.parent == b.parent) return a.crossings + crossings != b.crossings;
  members_[b.parent] = {a.parent, a.crossings + crossings - b.crossings};
  return false;
}

/// On each side on which the obstacle reaches over the bounds, it overlaps the outside, where nothing is crossed.
bool Separation::meets_bounds(const ObstacleField& field, ObstacleIndex index) {
  const Obstacle& obstacle = field.obstacles()[index];
  const Vec2& half = field.bounds().half_extent_m;
  const Polygon core = core_of(obstacle);
  const auto outside = static_cast<ObstacleIndex>(members_.size() - 1);
  for (const Vec2& axis : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)}) {
    Vec2 farthest = core.corners[0];
    for (std::uint32_t i = 1; i < core.count; ++i) {
      if (core.corners[i].dot(axis) > farthest.dot(axis)) farthest = core.corners[i];
    }
    if (farthest.dot(axis) + obstacle.radius_m <= half.dot(axis.cwiseAbs()) + kTouch_m) continue;
    const int out = crossings(middle_of(obstacle), farthest) + crossings(farthest, farthest + obstacle.radius_m * axis);
    if (closes(index, outside, out)) return true;
  }
  return false;
}

}  // namespace regista::graph
