#include "planning/planners/rrt.h"

#include <algorithm>

#include "planning/kd_tree.h"
#include "planning/polyline.h"
#include "planning/uniform.h"

namespace regista {
namespace {

constexpr double kStep_m = 0.36;       ///< λ of the paper
constexpr double kGoalReach_m = 0.36;  ///< d_goal of the paper
constexpr std::size_t kLeafSize = 5;   ///< the paper's choice (figures 8 and 9)
constexpr int kSamplesPerTimeCheck = 16;

/// A goal behind a moving obstacle's edge drifts from frame to frame; the old path still serves.
constexpr double kGoalDrift_m = 0.1;

class Tree {
 public:
  Tree(const ObstacleField& field, const Query& query)
      : field_(field), query_(query), nodes_(static_cast<std::size_t>(query.budget.iterations) + 2, kLeafSize) {
    nodes_.add(query.start);
    parents_.push_back(0);
  }

  /// Draws samples until the goal is connected or the budget is spent.
  bool grow() {
    std::mt19937_64 random(query_.seed);
    const Vec2& half = field_.bounds().half_extent_m;
    if (connects_to_goal()) return true;
    for (std::int64_t i = 0; i < query_.budget.iterations; ++i) {
      if (i % kSamplesPerTimeCheck == 0 && query_.budget.is_spent()) return false;
      const double x = uniform(random, -half.x(), half.x());
      const double y = uniform(random, -half.y(), half.y());
      if (extend({x, y}) && connects_to_goal()) return true;
    }
    return false;
  }

  /// From the start to a node.
  std::vector<Vec2> branch(std::size_t node) const {
    std::vector<Vec2> path{nodes_[node]};
    for (; node != 0; node = parents_[node]) path.push_back(nodes_[parents_[node]]);
    std::reverse(path.begin(), path.end());
    return path;
  }

  std::size_t newest() const { return nodes_.size() - 1; }
  std::size_t nearest_to_goal() const { return nodes_.nearest(query_.goal).index; }

 private:
  bool extend(const Vec2& sample) {
    const KdTree::Nearest nearest = nodes_.nearest(sample);
    if (nearest.distance_m == 0.0) return false;
    const Vec2 from = nodes_[nearest.index];
    const Vec2 to = from + (sample - from) * (kStep_m / nearest.distance_m);
    if (!field_.is_free(from, to, query_.ignored)) return false;
    nodes_.add(to);
    parents_.push_back(nearest.index);
    return true;
  }

  bool connects_to_goal() const {
    const Vec2& node = nodes_[newest()];
    return (node - query_.goal).norm() <= kGoalReach_m && field_.is_free(node, query_.goal, query_.ignored);
  }

  const ObstacleField& field_;
  const Query& query_;
  KdTree nodes_;
  std::vector<std::size_t> parents_;
};

}  // namespace

void Rrt::search(graph::SharedGraph& graph, const Query& query, SearchResult& result) {
  const ObstacleField& field = graph.field();
  if (query.is_straight_free) {
    result.path = {query.start, query.goal};
    result.status = PlanStatus::ok;
    return;
  }
  if (std::optional<std::vector<Vec2>> kept = kept_path(field, query, kGoalDrift_m)) {
    result.path = std::move(*kept);
    result.status = PlanStatus::ok;
    return;
  }
  Tree tree(field, query);
  if (tree.grow()) {
    std::vector<Vec2> path = tree.branch(tree.newest());
    path.push_back(query.goal);
    result.path = pruned(field, path, query.ignored);
    result.status = PlanStatus::ok;
  } else {
    result.path = pruned(field, tree.branch(tree.nearest_to_goal()), query.ignored);
    result.reason = "no way within the budget";
  }
}

}  // namespace regista
