// The tree that all rapidly exploring random trees of this folder grow (LaValle 1998): nearest node, one step towards
// the sample, kept if the step is free. They differ in what they draw and how far they step.
#pragma once

#include <functional>

#include "planning/planner.h"
#include "planning/uniform.h"

namespace regista {

struct RrtSteps {
  double step_m = 0.0;        ///< > 0
  double goal_reach_m = 0.0;  ///< a node this near to the goal is joined to it if that leg is free
  bool fixed = false;         ///< every step is step_m long; else a nearer sample is stepped onto
  std::size_t leaf_size = 5;  ///< of the KD-tree; 5 is the best of Costa & Tonidandel's figures 8 and 9
};

enum class RrtEnd { goal, samples_spent, no_time };

struct RrtBranch {
  RrtEnd end = RrtEnd::samples_spent;
  /// From the query's start, node by node, to its goal, or to the node nearest to it.
  std::vector<Vec2> path;
};

/// Grows a tree from the query's start with at most `samples` results of `draw`. Asks the budget for the time, not for
/// the iterations, and never again once the time is up.
RrtBranch grow_rrt(const ObstacleField& field, const Query& query, const RrtSteps& steps, std::int64_t samples,
                   const std::function<Vec2()>& draw);

/// Uniform within the bounds.
Vec2 uniform_point(std::mt19937_64& random, const Bounds& bounds);

/// What needs no tree: a free straight line, or the previous path when it is still free and leads to the same goal,
/// since every new tree gives another path and the robot would jitter. False when a tree is needed.
bool answered_without_tree(const ObstacleField& field, const Query& query, SearchResult& result);

/// A branch as a search's answer.
void answer_with(RrtBranch branch, SearchResult& result);

}  // namespace regista
