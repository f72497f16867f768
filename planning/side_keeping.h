// Keeps robots from changing their minds: vision noise makes the ways left and right of an obstacle the shorter one in
// turn. The side followed is kept by planning again with the other one closed, so it works for any planner.
#pragma once

#include "planning/planner.h"

namespace regista {

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
