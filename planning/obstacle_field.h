// One frame's obstacles, laid out so that a point or a straight motion is tested against all of them at once. Planners
// and the graph ask it, and it asks clearance.h wherever the fast test cannot say "free" for certain.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "planning/clearance.h"
#include "planning/obstacle_boxes.h"

namespace regista {

/// Where a robot's centre may be: |x| <= half_extent_m.x(), |y| <= half_extent_m.y(). Finite, >= 0.
struct Bounds {
  Vec2 half_extent_m = Vec2::Zero();
  bool operator==(const Bounds&) const = default;
};

/// True within the bounds; touching them (kTouch_m) is free.
inline bool is_inside(const Vec2& point, const Bounds& bounds) {
  return std::abs(point.x()) <= bounds.half_extent_m.x() + kTouch_m &&
         std::abs(point.y()) <= bounds.half_extent_m.y() + kTouch_m;
}

/// A capsule that holds all of the obstacle: itself, or the one around a rectangle's longer middle line.
Obstacle capsule_around(const Obstacle& obstacle);

/// Membership in a sorted list of ignored obstacles, which are few.
inline bool is_ignored(ObstacleIndex obstacle, std::span<const std::size_t> ignored) {
  for (const std::size_t i : ignored) {
    if (i >= obstacle) return i == obstacle;
  }
  return false;
}

/// An obstacle blocks where the clearance is below -kTouch_m. Lists of ignored obstacles are sorted indices.
class ObstacleField {
 public:
  ObstacleField() = default;

  /// Throws std::invalid_argument, with the value in the text, on an obstacle that is not valid or bounds that are not
  /// finite or negative.
  ObstacleField(const Bounds& bounds, std::vector<Obstacle> obstacles);

  /// The same in the memory of the old field, which stays when this throws.
  void assign(const Bounds& bounds, std::span<const Obstacle> obstacles);

  const Bounds& bounds() const { return bounds_; }
  std::span<const Obstacle> obstacles() const { return obstacles_; }
  std::size_t size() const { return obstacles_.size(); }

  /// Inside the bounds and in no obstacle but ignored ones; for a segment, all of it.
  bool is_free(const Vec2& point, std::span<const std::size_t> ignored = {}) const {
    return is_free(point, point, ignored);
  }
  bool is_free(const Vec2& from, const Vec2& to, std::span<const std::size_t> ignored = {}) const {
    return is_inside(from, bounds_) && is_inside(to, bounds_) && !first_blocker(from, to, ignored);
  }

  /// All legs of the path, which may be empty.
  bool is_free(std::span<const Vec2> path, std::span<const std::size_t> ignored) const;

  /// An obstacle that blocks the segment (bounds are not asked), if any.
  std::optional<ObstacleIndex> first_blocker(const Vec2& from, const Vec2& to,
                                             std::span<const std::size_t> ignored = {}) const;

  /// Appends all obstacles that block the segment to `out`; which of them an asker ignores is his affair.
  void blockers(const Vec2& from, const Vec2& to, std::vector<ObstacleIndex>& out) const;

  /// Appends all obstacles that cover the point to `out`.
  void covering(const Vec2& point, std::vector<ObstacleIndex>& out) const { blockers(point, point, out); }

  /// Calls visit(index) for all obstacles that block the segment and for some that do not, until it returns true.
  template <class Visit>
  void visit_candidates(const ObstacleBoxes::Motion& motion, Visit&& visit) const {
    boxes_.visit_near(motion, visit);
  }

  /// Calls visit(index) for all obstacles that come nearer than radius_m to the segment, and for some that do not.
  template <class Visit>
  void visit_maybe_near(const Vec2& from, const Vec2& to, double radius_m, Visit&& visit) const {
    boxes_.visit_near(from, to, radius_m, [&](ObstacleIndex i) {
      visit(i);
      return false;
    });
  }

  /// Calls visit(index) for all obstacles within radius_m of the point and for some that are farther.
  template <class Visit>
  void maybe_within(const Vec2& point, double radius_m, Visit&& visit) const {
    visit_maybe_near(point, point, radius_m, visit);
  }

  /// Calls visit(index) for all obstacles nearer than `margin_m` to the given one of the field, and for some that are
  /// farther; itself left out.
  template <class Visit>
  void visit_maybe_near(ObstacleIndex obstacle, double margin_m, Visit&& visit) const {
    const Obstacle stadium = capsule_around(obstacles_[obstacle]);
    visit_maybe_near(stadium.a, stadium.b, stadium.radius_m + margin_m, [&](ObstacleIndex i) {
      if (i != obstacle) visit(i);
    });
  }

 private:
  bool is_run_free(std::span<const Vec2> run, double length_m, std::span<const std::size_t> ignored) const;

  Bounds bounds_;
  std::vector<Obstacle> obstacles_;
  ObstacleBoxes boxes_;
};

}  // namespace regista
