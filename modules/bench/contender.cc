#include "modules/bench/contender.h"

#include <algorithm>

#include "modules/bench/stopwatch.h"

namespace regista::bench {

Contenders make_contenders(const std::vector<std::string>& names, const PlanningParams& params) {
  Contenders contenders;
  for (const std::string& name : names) contenders.push_back({name, make_planner(name, params)});
  if (!contenders.empty()) return contenders;
  for (const PlannerEntry& entry : planners()) contenders.push_back({std::string(entry.name), entry.make(params)});
  return contenders;
}

bool is_registered(std::string_view planner) {
  return std::any_of(planners().begin(), planners().end(),
                     [planner](const PlannerEntry& entry) { return entry.name == planner; });
}

Shot plan_once(Contender& contender, const World& world, PlanRequest request, double budget_us) {
  const std::vector<Obstacle> obstacles = world.obstacles;  // as if just made
  contender.graph.clear();
  Shot shot;
  const SingleShot whole;
  contender.graph.reset(world.bounds, obstacles);
  const SingleShot planning;
  const std::function<bool()> out_of_time = [&planning, budget_us] { return planning.us() >= budget_us; };
  if (budget_us > 0.0) request.budget.out_of_time = &out_of_time;
  contender.planner->plan(contender.graph, request, contender.answer);
  shot.plan_us = planning.us();
  shot.total_us = whole.us();
  return shot;
}

std::vector<std::size_t> rotated(std::size_t count, std::size_t round) {
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = (i + round) % count;
  return order;
}

}  // namespace regista::bench
