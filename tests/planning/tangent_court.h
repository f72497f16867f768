// The exact planner before its judge, tests/support/tangent_oracle.h: same reachability, same length, free paths.
#pragma once

#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "planning/graph/tangent_search.h"
#include "planning/registry.h"

namespace regista::testing {

/// One world after the other through search, planner and judge.
class Court {
 public:
  /// What is wrong with the planner's answers, with a query to paste on stderr; empty when nothing is. Worlds whose
  /// start or goal is covered are not looked at.
  std::string fault(const ObstacleField& field, const PlanRequest& request);
  std::string fault(const ObstacleField& field, const Vec2& start, const Vec2& goal);

  int worlds() const { return worlds_; }
  int bent() const { return bent_; }
  int unreachable() const { return unreachable_; }
  int known_free() const { return known_free_; }

 private:
  std::string fault_of_search(const PlanRequest& request);
  std::string fault_of_plan(const PlanRequest& request);

  std::unique_ptr<Planner> planner_ = make_planner("tangent");
  graph::TangentSearch search_;
  graph::SharedGraph graph_;
  std::vector<Vec2> path_;
  std::optional<double> expected_m_;
  int worlds_ = 0, bent_ = 0, unreachable_ = 0, known_free_ = 0;
};

/// Random numbers of the world of that number.
inline std::mt19937_64 generator(int world) { return std::mt19937_64(static_cast<std::uint64_t>(world)); }

}  // namespace regista::testing
