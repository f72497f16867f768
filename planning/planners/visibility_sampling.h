// Visibility sampling on the graph that the whole team shares: what the ZJUNlict paper names as future work ("we can do
// the search on the same graph").
#pragma once

#include "planning/graph/visibility_search.h"
#include "planning/planner.h"

namespace regista {

class VisibilitySampling : public Planner {
 protected:
  void search(graph::SharedGraph& graph, const Query& query, SearchResult& result) override;

 private:
  graph::VisibilitySearch search_;
};

}  // namespace regista
