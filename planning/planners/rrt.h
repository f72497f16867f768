// Rapidly exploring random tree as Costa & Tonidandel compare it with DVG+A*: no goal bias, fixed step, KD-tree, the
// path pruned afterwards ("RRT", section 4).
#pragma once

#include "planning/planner.h"
#include "planning/planning_params.h"

namespace regista {

/// Steps have the fixed length λ as printed. Two things are added for a robot that drives: a free straight line is
/// taken without a tree (2,500 samples without goal bias miss one goal in forty), and a previous path that is still
/// free and leads to the same goal is kept, since every new tree gives another path.
class Rrt : public Planner {
 public:
  explicit Rrt(const PlanningParams& params = {}) : params_(params.rrt) {}

 protected:
  void search(graph::SharedGraph& graph, const Query& query, SearchResult& result) override;

 private:
  RrtParams params_;
};

}  // namespace regista
