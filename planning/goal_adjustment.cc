#include "planning/goal_adjustment.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "planning/outline.h"

namespace regista {
namespace {

/// The nearest point of a set that lies on the outlines of obstacles and bounds: on one of them as the projection of
/// `from`, or where two of them meet. Outlines are added in the order of their distance, and as soon as the next one is
/// farther than the best point so far, nothing better can come.
class NearestOnOutlines {
 public:
  using Test = std::function<bool(const Vec2&)>;

  NearestOnOutlines(const ObstacleField& field, const Vec2& from, std::span<const std::size_t> ignored, Test admits)
      : field_(field), from_(from), admits_(std::move(admits)) {
    for (ObstacleIndex i = 0; i < field.size(); ++i) {
      if (!is_ignored(i, ignored)) order_.push_back({std::abs(clearance(from, field.obstacles()[i])), i});
    }
    std::sort(order_.begin(), order_.end());
  }

  /// With rays, points on straight lines that graze an obstacle are candidates too.
  std::optional<Vec2> find(bool with_rays) {
    add(outline_of(field_.bounds()));
    for (const auto& [distance_m, index] : order_) {
      if (distance_m > best_m_) break;
      const Outline outline = outline_of(field_.obstacles()[index]);
      if (with_rays) add_rays(outline);
      add(outline);
    }
    return best_;
  }

 private:
  void add(const Outline& outline) {
    candidates_.clear();
    append_projections(from_, outline, candidates_);
    for (const Outline& other : added_) append_intersections(outline, other, candidates_);
    added_.push_back(outline);
    try_candidates();
  }

  void add_rays(const Outline& outline) {
    rays_.clear();
    const double length_m = 2.0 * (field_.bounds().half_extent_m.norm() + from_.norm());
    append_tangents(from_, outline, length_m, rays_);
    candidates_.clear();
    for (const Outline& ray : rays_) {
      for (const Outline& other : added_) append_intersections(ray, other, candidates_);
      added_.push_back(ray);
    }
    try_candidates();
  }

  void try_candidates() {
    for (const Vec2& candidate : candidates_) {
      const double distance_m = (candidate - from_).norm();
      if (distance_m >= best_m_ || !admits_(candidate)) continue;
      best_m_ = distance_m;
      best_ = candidate;
    }
  }

  const ObstacleField& field_;
  Vec2 from_;
  Test admits_;
  std::vector<std::pair<double, ObstacleIndex>> order_;
  std::vector<Outline> added_;
  std::vector<Outline> rays_;
  std::vector<Vec2> candidates_;
  double best_m_ = std::numeric_limits<double>::infinity();
  std::optional<Vec2> best_;
};

/// Rounding may put a point on the bounds a hair outside; touching is free, but nobody need see it.
std::optional<Vec2> clamped(std::optional<Vec2> point, const Bounds& bounds) {
  if (point) *point = point->cwiseMax(-bounds.half_extent_m).cwiseMin(bounds.half_extent_m);
  return point;
}

}  // namespace

std::optional<Vec2> nearest_free_point(const ObstacleField& field, const Vec2& point,
                                       std::span<const std::size_t> ignored) {
  if (field.is_free(point, ignored)) return point;
  const auto is_free = [&](const Vec2& candidate) { return field.is_free(candidate, ignored); };
  return clamped(NearestOnOutlines(field, point, ignored, is_free).find(false), field.bounds());
}

std::optional<Vec2> way_out(const ObstacleField& field, const Vec2& start, std::span<const std::size_t> ignored) {
  if (field.is_free(start, ignored)) return start;
  std::vector<ObstacleIndex> covering;
  field.covering(start, covering);
  std::vector<std::size_t> crossed(ignored.begin(), ignored.end());
  crossed.insert(crossed.end(), covering.begin(), covering.end());
  std::sort(crossed.begin(), crossed.end());
  const auto is_way_out = [&](const Vec2& candidate) {
    return field.is_free(candidate, ignored) && !field.first_blocker(start, candidate, crossed);
  };
  return clamped(NearestOnOutlines(field, start, ignored, is_way_out).find(true), field.bounds());
}

}  // namespace regista
