// The exact shortest path, from the shared graph's obstacles: what all other planners are measured against.
#pragma once

#include "planning/graph/tangent_search.h"
#include "planning/planner.h"

namespace regista {

/// Complete and optimal: `unreachable` is a proof, and no path is shorter by more than the 0.1 % that arcs lose by
/// becoming polylines.
class TangentPlanner : public Planner {
 protected:
  void search(graph::SharedGraph& graph, const Query& query, SearchResult& result) override;

 private:
  graph::TangentSearch search_;
};

}  // namespace regista
