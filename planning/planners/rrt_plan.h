// RRT-Plan and RRT-Smooth of "Path finding based on iterative RRT-Smooth": a tree with goal bias and steps of ε, its
// branch as it is or smoothed.
#pragma once

#include "planning/planner.h"
#include "planning/planning_params.h"

namespace regista {

/// The paper's figure 6. What it does not say and is done here: the whole step is tested, not its end alone, a sample
/// nearer than ε is stepped onto, and what `rrt` adds for a robot that drives is added here too.
class RrtPlan : public Planner {
 public:
  explicit RrtPlan(const PlanningParams& params = {}) : params_(params.irrt) {}

 protected:
  void search(graph::SharedGraph& graph, const Query& query, SearchResult& result) override;

 private:
  IterativeRrtParams params_;
};

/// And figure 7: all nodes between two that see each other are dropped.
class RrtSmooth : public RrtPlan {
 public:
  using RrtPlan::RrtPlan;

 protected:
  void search(graph::SharedGraph& graph, const Query& query, SearchResult& result) override;
};

}  // namespace regista
