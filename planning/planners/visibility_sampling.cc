#include "planning/planners/visibility_sampling.h"

namespace regista {

void VisibilitySampling::search(graph::SharedGraph& graph, const Query& query, SearchResult& result) {
  if (query.is_straight_free) {
    result.path.push_back(query.start);
    result.path.push_back(query.goal);
    result.status = PlanStatus::ok;
    return;
  }
  using End = graph::VisibilitySearch::End;
  const End end = search_.find(graph, query, result.path);
  if (end == End::goal) {
    result.status = PlanStatus::ok;
  } else if (end == End::no_way) {
    result.status = PlanStatus::unreachable;
    result.reason = "obstacles close every way";
  } else {
    result.reason = end == End::no_time ? "the time was spent" : "no way over the samples";
  }
}

}  // namespace regista
