#include "planning/planners/rrt.h"

#include "planning/planners/rrt_tree.h"
#include "planning/polyline.h"

namespace regista {

void Rrt::search(graph::SharedGraph& graph, const Query& query, SearchResult& result) {
  const ObstacleField& field = graph.field();
  if (answered_without_tree(field, query, result)) return;
  std::mt19937_64 random(query.seed);
  const RrtSteps steps{params_.step_m, params_.goal_reach_m, true, static_cast<std::size_t>(params_.leaf_size)};
  RrtBranch branch =
      grow_rrt(field, query, steps, query.budget.iterations, [&] { return uniform_point(random, field.bounds()); });
  branch.path = pruned(field, branch.path, query.ignored);
  answer_with(std::move(branch), result);
}

}  // namespace regista
