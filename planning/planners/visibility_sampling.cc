#include "planning/planners/visibility_sampling.h"

namespace regista {

void VisibilitySampling::search(graph::SharedGraph& graph, const Query& query, SearchResult& result) {
  if (!graph.field().first_blocker(query.start, query.goal, query.ignored)) {
    result.path.push_back(query.start);
    result.path.push_back(query.goal);
    result.status = PlanStatus::ok;
  } else if (search_.find(graph, query, result.path)) {
    result.status = PlanStatus::ok;
  } else {
    result.reason = query.budget.is_spent() ? "the time was spent" : "no way over the samples";
  }
}

}  // namespace regista
