// Covered starts and goals: the nearest free point, and the shortest straight way out. Exact: candidates are all places
// where the nearest point can be, tried in order of distance.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "planning/obstacle_field.h"
#include "planning/outline.h"

namespace regista {

/// Only scratch memory is kept between two questions.
class GoalAdjustment {
 public:
  /// The free point nearest to `point` (itself when free): inside the bounds, in no obstacle but ignored ones. Nothing
  /// when there is none at all.
  std::optional<Vec2> nearest_free_point(const ObstacleField& field, const Vec2& point,
                                         std::span<const std::size_t> ignored = {});

  /// The free point nearest to `start` that a straight leg reaches while crossing only obstacles that cover the start;
  /// the outside of the bounds counts as covering a start that lies there. Nothing when there is none.
  std::optional<Vec2> way_out(const ObstacleField& field, const Vec2& start, std::span<const std::size_t> ignored = {});

 private:
  std::optional<Vec2> nearest(const ObstacleField& field, const Vec2& point, std::span<const std::size_t> ignored,
                              bool is_way_out);
  std::optional<Vec2> nearest_on_outlines();
  bool admits(const Vec2& candidate, double distance_m);
  bool is_in_shadow(const Vec2& candidate) const;
  void find_nearest();
  void find_covering();
  bool is_border(ObstacleIndex obstacle) const;
  double farthest_border_m() const;
  bool is_held(ObstacleIndex obstacle) const;
  bool try_deepest();
  bool try_within(double radius_m, bool with_rays);
  void add(const Outline& outline, bool border);
  void add_rays(const Outline& outline);
  void try_candidates();

  const ObstacleField* field_ = nullptr;  ///< of the question that is being answered, as all up to best_
  std::span<const std::size_t> ignored_;
  Vec2 from_ = Vec2::Zero();
  bool is_way_out_ = false;
  double best_m_ = std::numeric_limits<double>::infinity();
  double shadowed_m_ = std::numeric_limits<double>::infinity();  ///< nearest free point that no straight leg reaches
  double deepest_m_ = 0.0;  ///< how deep the point is covered; nothing free is nearer
  std::optional<Vec2> best_;
  std::vector<ObstacleIndex> covering_;
  std::vector<std::size_t> crossed_;  ///< what a way out may cross: ignored and covering obstacles, sorted
  std::vector<std::pair<double, ObstacleIndex>> order_;
  std::vector<ObstacleIndex> nearest_;  ///< of those that a way out may not cross
  std::vector<Outline> added_;
  std::vector<Outline> borders_;  ///< those of the added ones on which the answer may lie
  std::vector<Outline> rays_;
  std::vector<Vec2> candidates_;
};

/// The same without memory to reuse.
inline std::optional<Vec2> nearest_free_point(const ObstacleField& field, const Vec2& point,
                                              std::span<const std::size_t> ignored = {}) {
  return GoalAdjustment().nearest_free_point(field, point, ignored);
}
inline std::optional<Vec2> way_out(const ObstacleField& field, const Vec2& start,
                                   std::span<const std::size_t> ignored = {}) {
  return GoalAdjustment().way_out(field, start, ignored);
}

}  // namespace regista
