#include "planning/planners/rrt_plan.h"

#include "planning/planners/rrt_tree.h"
#include "planning/polyline.h"

namespace regista {

void RrtPlan::search(graph::SharedGraph& graph, const Query& query, SearchResult& result) {
  const ObstacleField& field = graph.field();
  if (answered_without_tree(field, query, result)) return;
  std::mt19937_64 random(query.seed);
  const auto choose_target = [&] {
    return uniform(random) < params_.goal_bias ? query.goal : uniform_point(random, field.bounds());
  };
  const RrtSteps steps{.step_m = params_.epsilon_m, .goal_reach_m = params_.epsilon_m};
  answer_with(grow_rrt(field, query, steps, query.budget.iterations, choose_target), result);
}

void RrtSmooth::search(graph::SharedGraph& graph, const Query& query, SearchResult& result) {
  RrtPlan::search(graph, query, result);
  result.path = pruned(graph.field(), result.path, query.ignored);
}

}  // namespace regista
