// A planner as a bench runs it: with a graph and an answer whose memory is reused, one single shot per query.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "modules/bench/worlds.h"
#include "planning/registry.h"

namespace regista::bench {

/// Queries a planner gets in a row before the next one's turn: as many, so as warm, as in a team's frame. With 1 the
/// caches are cold.
inline constexpr std::size_t kBatch = 11;

struct Contender {
  std::string name;
  std::unique_ptr<Planner> planner;
  graph::SharedGraph graph = {};
  Plan answer = {};  ///< to the last query
};

using Contenders = std::vector<Contender>;

/// By their names in the registry; all of it for none. Throws UnknownPlanner.
Contenders make_contenders(const std::vector<std::string>& names, const PlanningParams& params = {});

bool is_registered(std::string_view planner);

struct Shot {
  double total_us = 0.0;  ///< laying out the field and the graph, and planning
  double plan_us = 0.0;   ///< planning alone
};

/// One query from nothing: field and graph of this query are built. With a budget > 0 the planner is told to stop when
/// that much of its planning time is over. The answer is in contender.answer.
Shot plan_once(Contender& contender, const World& world, PlanRequest request, double budget_us = 0.0);

/// 0 … count - 1, beginning with another one each round.
std::vector<std::size_t> rotated(std::size_t count, std::size_t round);

}  // namespace regista::bench
