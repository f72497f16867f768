// Extended RRT (Bruce & Veloso 2002) with the constants of Pinheiro, Maximo & Yoneyama (LARS 2020): some samples are
// the goal, some are waypoints of the path found before, the rest is uniform.
#pragma once

#include "planning/planner.h"
#include "planning/planning_params.h"

namespace regista {

/// A planner keeps nothing between frames, so the waypoint cache is the query's previous path; without one its share
/// of the samples is uniform. The path leaves as the tree has it, not smoothed, as published, so that its nodes are
/// waypoints for the next frame. A free straight line is taken without a tree.
class Errt : public Planner {
 public:
  explicit Errt(const PlanningParams& params = {}) : params_(params.errt) {}

 protected:
  void search(graph::SharedGraph& graph, const Query& query, SearchResult& result) override;

 private:
  ErrtParams params_;
};

}  // namespace regista
