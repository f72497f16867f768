#include "planning/planners/visibility_sampling_single.h"

#include <algorithm>
#include <limits>
#include <queue>

#include "planning/graph/samples.h"
#include "planning/kd_tree.h"

namespace regista {
namespace {

/// Samples nearer to a node than this are that node.
constexpr double kSameNode_m = 1e-3;

/// Nodes 0 and 1 are start and goal.
class PublishedGraph {
 public:
  PublishedGraph(const ObstacleField& field, const Query& query)
      : field_(field), query_(query), marked_(field.size(), false), nodes_(2 + samples_max()) {
    nodes_.add(query.start);
    nodes_.add(query.goal);
    neighbours_.resize(2);
  }

  /// False when the time was up before it was complete.
  bool build() {
    for (std::size_t later = 1; later < nodes_.size(); ++later) {
      if (query_.budget.is_spent()) return false;
      for (std::size_t earlier = 0; earlier < later; ++earlier) connect(earlier, later);
    }
    return true;
  }

  /// A*; empty when the goal is not connected. `nearest` gets the path to the connected node nearest to the goal.
  std::vector<Vec2> shortest_path(std::vector<Vec2>& nearest) const;

 private:
  std::size_t samples_max() const {
    std::size_t count = 0;
    for (const Obstacle& obstacle : field_.obstacles()) count += graph::samples_max(obstacle);
    return count;
  }

  void connect(std::size_t one, std::size_t other) {
    blockers_.clear();
    const Vec2 from = nodes_[one];
    const Vec2 to = nodes_[other];
    field_.blockers(from, to, blockers_);
    drop_ignored();
    if (blockers_.empty()) {
      neighbours_[one].push_back(other);
      neighbours_[other].push_back(one);
    } else {
      sample_and_add_points();
    }
  }

  void drop_ignored() {
    std::erase_if(blockers_, [this](ObstacleIndex i) { return is_ignored(i, query_.ignored); });
  }

  /// For the obstacles in blockers_; what covers a sample is appended to them.
  void sample_and_add_points() {
    while (!blockers_.empty()) {
      const ObstacleIndex obstacle = blockers_.back();
      blockers_.pop_back();
      if (marked_[obstacle]) continue;
      marked_[obstacle] = true;
      samples_.clear();
      graph::append_samples(field_, obstacle, samples_);
      for (const Vec2& sample : samples_) {
        const std::size_t waiting = blockers_.size();
        field_.covering(sample, blockers_);
        drop_ignored();
        if (blockers_.size() > waiting || nodes_.nearest(sample).distance_m < kSameNode_m) continue;
        nodes_.add(sample);
        neighbours_.emplace_back();
      }
    }
  }

  std::vector<Vec2> trace(std::span<const std::size_t> parents, std::size_t last) const {
    std::vector<Vec2> path{nodes_[last]};
    for (std::size_t node = last; node != 0; node = parents[node]) path.push_back(nodes_[parents[node]]);
    std::reverse(path.begin(), path.end());
    return path;
  }

  const ObstacleField& field_;
  const Query& query_;
  std::vector<bool> marked_;
  KdTree nodes_;
  std::vector<std::vector<std::size_t>> neighbours_;
  std::vector<ObstacleIndex> blockers_;
  std::vector<Vec2> samples_;
};

std::vector<Vec2> PublishedGraph::shortest_path(std::vector<Vec2>& nearest) const {
  const auto to_goal = [this](std::size_t node) { return (nodes_[node] - query_.goal).norm(); };
  std::vector<double> cost(neighbours_.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> parents(neighbours_.size(), 0);
  std::vector<bool> closed(neighbours_.size(), false);
  std::priority_queue<std::pair<double, std::size_t>, std::vector<std::pair<double, std::size_t>>, std::greater<>> open;
  std::size_t best = 0;
  cost[0] = 0.0;
  open.push({to_goal(0), 0});
  while (!open.empty()) {
    const std::size_t node = open.top().second;
    open.pop();
    if (closed[node]) continue;
    closed[node] = true;
    if (node == 1) return trace(parents, 1);
    if (to_goal(node) < to_goal(best)) best = node;
    for (const std::size_t next : neighbours_[node]) {
      const double through = cost[node] + (nodes_[next] - nodes_[node]).norm();
      if (through >= cost[next]) continue;
      cost[next] = through;
      parents[next] = node;
      open.push({through + to_goal(next), next});
    }
  }
  nearest = trace(parents, best);
  return {};
}

}  // namespace

void VisibilitySamplingSingle::search(graph::SharedGraph& graph, const Query& query, SearchResult& result) {
  PublishedGraph published(graph.field(), query);
  const bool complete = published.build();
  std::vector<Vec2> nearest;
  result.path = published.shortest_path(nearest);
  if (!result.path.empty()) {
    result.status = PlanStatus::ok;
    return;
  }
  result.path = std::move(nearest);
  result.reason = complete ? "no way over the samples" : "the time was spent";
}

}  // namespace regista
