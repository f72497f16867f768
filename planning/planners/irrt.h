// Iterative RRT and Iterative RRT-Smooth of "Path finding based on iterative RRT-Smooth": a tree from the start and one
// from the goal, the shorter path, within a rectangle along the straight line that doubles its width until there is
// one.
#pragma once

#include "planning/planner.h"
#include "planning/planning_params.h"

namespace regista {

/// The paper does not say how much a rectangle may cost. Here each gets an eighth of the samples that remain, half for
/// either tree, and the one that holds the whole field gets them all. The rectangle reaches half its width beyond start
/// and goal.
class Irrt : public Planner {
 public:
  explicit Irrt(const PlanningParams& params = {}) : params_(params.irrt) {}

 protected:
  void search(graph::SharedGraph& graph, const Query& query, SearchResult& result) override;

 private:
  IterativeRrtParams params_;
};

/// And the path smoothed as RRT-Smooth does.
class IrrtSmooth : public Irrt {
 public:
  using Irrt::Irrt;

 protected:
  void search(graph::SharedGraph& graph, const Query& query, SearchResult& result) override;
};

}  // namespace regista
