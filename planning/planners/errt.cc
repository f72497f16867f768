#include "planning/planners/errt.h"

#include "planning/planners/rrt_tree.h"

namespace regista {

void Errt::search(graph::SharedGraph& graph, const Query& query, SearchResult& result) {
  const ObstacleField& field = graph.field();
  if (field.is_free(query.start, query.goal, query.ignored)) {
    result.path = {query.start, query.goal};
    result.status = PlanStatus::ok;
    return;
  }
  std::mt19937_64 random(query.seed);
  const std::span<const Vec2> cache = query.previous_path;
  const auto sample_space = [&] {
    const double choice = uniform(random);
    if (choice < params_.goal_bias) return query.goal;
    if (choice < params_.goal_bias + params_.waypoint_bias && !cache.empty()) {
      return cache[static_cast<std::size_t>(uniform(random) * static_cast<double>(cache.size()))];
    }
    return uniform_point(random, field.bounds());
  };
  const RrtSteps steps{.step_m = params_.step_m, .goal_reach_m = params_.step_m};
  answer_with(grow_rrt(field, query, steps, query.budget.iterations, sample_space), result);
}

}  // namespace regista
