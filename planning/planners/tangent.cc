#include "planning/planners/tangent.h"

namespace regista {

void TangentPlanner::search(graph::SharedGraph& graph, const Query& query, SearchResult& result) {
  if (query.is_straight_free) {
    result.path.push_back(query.start);
    result.path.push_back(query.goal);
    result.status = PlanStatus::ok;
    return;
  }
  using End = graph::TangentSearch::End;
  const End end = search_.find(graph, query, result.path);
  if (end == End::goal) {
    result.is_known_free = search_.is_path_known_free();
    result.status = PlanStatus::ok;
  } else if (end == End::no_way) {
    result.status = PlanStatus::unreachable;
    result.reason = "obstacles close every way";
  } else {
    result.reason = end == End::no_time ? "the time was spent" : "every way is longer than asked for";
  }
}

}  // namespace regista
