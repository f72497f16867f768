// Keeps robots from changing their minds: vision noise makes the ways left and right of an obstacle the shorter one in
// turn. Whether two paths pass an obstacle on the same side is asked of the curve they enclose, so it holds for any
// planner's paths; the side is kept by planning again with the other one closed.
#pragma once

#include "planning/planner.h"

namespace regista {

/// Appends the obstacles, ignored ones left out, that the two paths pass on different sides: the curve along `now` and
/// back along `before` winds around their middle. Neither path is empty; their ends may be a little apart.
void append_passed_otherwise(std::span<const Obstacle> obstacles, std::span<const std::size_t> ignored,
                             std::span<const Vec2> before, std::span<const Vec2> now, std::vector<ObstacleIndex>& out);

/// Both ends of the paths are so near each other that sides can be compared; false for an empty path.
bool is_same_errand(std::span<const Vec2> before, std::span<const Vec2> now);

/// A change of side, as it is counted: both plans ok, for the same target, and passing some obstacle of the newer
/// plan's field on different sides. The plans are those of consecutive world states.
bool changes_side(const ObstacleField& field, std::span<const std::size_t> ignored, const RobotPlan& before,
                  const RobotPlan& now);

class SideKeeper {
 public:
  /// `found` is the planner's answer to the request in that field. Where it passes an obstacle on another side than the
  /// request's previous path does, it is replaced by a path that does not and is at most `gain` (a share of its length,
  /// >= 0) longer than it, if there is one. A function of its arguments; the rest is memory.
  void keep(Planner& planner, const ObstacleField& field, const PlanRequest& request, double gain, Plan& found);

 private:
  bool search(Planner& planner, const ObstacleField& field, const PlanRequest& request, double longest_m, Plan& found);
  bool close(const ObstacleField& field, std::span<const Vec2> before, std::span<const Vec2> now);

  graph::SharedGraph graph_;
  std::vector<Obstacle> obstacles_;  ///< the field's and the barriers behind them: indices keep their meaning
  std::vector<ObstacleIndex> passed_otherwise_;
};

}  // namespace regista
