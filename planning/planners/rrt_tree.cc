#include "planning/planners/rrt_tree.h"

#include <algorithm>

#include "planning/kd_tree.h"
#include "planning/polyline.h"

namespace regista {
namespace {

constexpr int kSamplesPerTimeCheck = 16;

/// A goal behind a moving obstacle's edge drifts from frame to frame; the old path still serves.
constexpr double kGoalDrift_m = 0.1;

class Tree {
 public:
  Tree(const ObstacleField& field, const Query& query, const RrtSteps& steps, std::int64_t samples)
      : field_(field), query_(query), steps_(steps), nodes_(static_cast<std::size_t>(samples) + 2, steps.leaf_size) {
    nodes_.add(query.start);
    parents_.push_back(0);
  }

  RrtEnd grow(std::int64_t samples, const std::function<Vec2()>& draw) {
    if (connects_to_goal()) return RrtEnd::goal;
    for (std::int64_t i = 0; i < samples; ++i) {
      if (i % kSamplesPerTimeCheck == 0 && query_.budget.is_spent()) return RrtEnd::no_time;
      if (extend(draw()) && connects_to_goal()) return RrtEnd::goal;
    }
    return RrtEnd::samples_spent;
  }

  /// From the root to a node.
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
    Vec2 to = sample;
    if (steps_.fixed || nearest.distance_m > steps_.step_m) {
      to = from + (sample - from) * (steps_.step_m / nearest.distance_m);
    }
    if (!field_.is_free(from, to, query_.ignored)) return false;
    nodes_.add(to);
    parents_.push_back(nearest.index);
    return true;
  }

  bool connects_to_goal() const {
    const Vec2& node = nodes_[newest()];
    return (node - query_.goal).norm() <= steps_.goal_reach_m && field_.is_free(node, query_.goal, query_.ignored);
  }

  const ObstacleField& field_;
  const Query& query_;
  const RrtSteps& steps_;
  KdTree nodes_;
  std::vector<std::size_t> parents_;
};

}  // namespace

RrtBranch grow_rrt(const ObstacleField& field, const Query& query, const RrtSteps& steps, std::int64_t samples,
                   const std::function<Vec2()>& draw) {
  Tree tree(field, query, steps, samples);
  RrtBranch branch;
  branch.end = tree.grow(samples, draw);
  if (branch.end != RrtEnd::goal) {
    branch.path = tree.branch(tree.nearest_to_goal());
    return branch;
  }
  branch.path = tree.branch(tree.newest());
  if (branch.path.back() != query.goal) branch.path.push_back(query.goal);
  return branch;
}

Vec2 uniform_point(std::mt19937_64& random, const Bounds& bounds) {
  const Vec2& half = bounds.half_extent_m;
  const double x = uniform(random, -half.x(), half.x());
  const double y = uniform(random, -half.y(), half.y());
  return {x, y};
}

bool answered_without_tree(const ObstacleField& field, const Query& query, SearchResult& result) {
  if (field.is_free(query.start, query.goal, query.ignored)) {
    result.path = {query.start, query.goal};
  } else if (std::optional<std::vector<Vec2>> kept = kept_path(field, query, kGoalDrift_m)) {
    result.path = std::move(*kept);
  } else {
    return false;
  }
  result.status = PlanStatus::ok;
  return true;
}

void answer_with(RrtBranch branch, SearchResult& result) {
  result.path = std::move(branch.path);
  switch (branch.end) {
    case RrtEnd::goal:
      result.status = PlanStatus::ok;
      return;
    case RrtEnd::samples_spent:
      result.reason = "no way within the samples";
      return;
    case RrtEnd::no_time:
      result.reason = "the time was spent";
      return;
  }
}

}  // namespace regista
