#include "planning/graph/visibility_front.h"

#include <algorithm>

namespace regista::graph {
namespace {

constexpr int kEdgesPerTimeCheck = 64;

/// A search that has come to an end looks for other obstacles that near at first; what is that far apart is no gap that
/// is hard to get through.
constexpr double kRestWithin_m = kNear_m;

}  // namespace

void VisibilityFront::begin(SharedGraph& graph, const Query& query) {
  query_ = query;
  field_ = &graph.field();
  nodes_.clear();
  targets_.clear();
  expanded_.clear();
  edges_.clear();
  queue_.clear();
  marked_.clear(field_->size());
  detours_.clear();
  occluders_ = {};
  edges_tested_ = 0;
  rest_within_m_ = kRestWithin_m;
  targets_checked_at_ = 0;
  last_ = kStart;
  limit_m_ = kDetour * (query.goal - query.start).norm() + kDetour_m;
  least_beyond_m_ = kInfinity;
  add_node(query.start, 0, kBounds);
  add_node(query.goal, 0, kBounds);
  targets_.erase(targets_.begin());  // nothing leads back to the start
  nodes_[kStart].cost = 0.0;
  if (query.straight_blockers.empty()) {
    expand(kStart);
    return;
  }
  nodes_[kStart].is_expanded = true;
  expanded_.push_back(kStart);
  mark(graph, worth_marking(query.start, query.goal, query.straight_blockers));
}

VisibilityFront::Progress VisibilityFront::advance(SharedGraph& graph, int edges) {
  for (const int end = edges_tested_ + edges; edges_tested_ < end;) {
    const Edge* const next = next_edge();
    if (next == nullptr) {
      if (!widen() && !mark_rest(graph)) return Progress::no_samples;
      if (query_.budget.is_spent()) return Progress::no_time;
      continue;
    }
    const Edge edge = *next;
    ++edges_tested_;
    if (edges_tested_ % kEdgesPerTimeCheck == 0 && query_.budget.is_spent()) return Progress::no_time;
    if (const ObstacleIndex covered_by = nodes_[edge.to].covered_by; covered_by != kBounds) {
      mark(graph, covered_by);
      continue;
    }
    if (!is_open(graph, edge)) continue;
    Node& node = nodes_[edge.to];
    node.cost = edge.cost;
    node.parent = edge.from;
    if (edge.to == kGoal) {
      last_ = kGoal;
      return Progress::goal;
    }
    if (node.to_goal_m < nodes_[last_].to_goal_m) last_ = edge.to;
    expand(edge.to);
  }
  return Progress::going_on;
}

void VisibilityFront::add_node(const Vec2& position, NodeId shared, ObstacleIndex covered_by) {
  targets_.push_back(static_cast<Local>(nodes_.size()));
  const double to_goal_m = (query_.goal - position).norm();
  nodes_.push_back({position, kInfinity, to_goal_m, to_goal_m, kStart, shared, covered_by, 0, false});
}

void VisibilityFront::add_samples(SharedGraph& graph, ObstacleIndex obstacle) {
  const SharedGraph::Samples samples = graph.samples(obstacle);
  for (NodeId node = samples.first; node < samples.first + samples.count; ++node) {
    const std::span<const ObstacleIndex> covering = graph.covering(node);
    const Vec2& position = graph.position(node);
    const ObstacleIndex covered_by = covering.empty() ? kBounds : worth_marking(position, position, covering);
    if (covered_by != kBounds || !blocks_one(covering)) add_node(position, node, covered_by);
  }
}

bool VisibilityFront::blocks_one(std::span<const ObstacleIndex> obstacles) const {
  return std::any_of(obstacles.begin(), obstacles.end(),
                     [this](ObstacleIndex i) { return !is_ignored(i, query_.ignored); });
}

ObstacleIndex VisibilityFront::worth_marking(const Vec2& from, const Vec2& to,
                                             std::span<const ObstacleIndex> blockers) const {
  ObstacleIndex deepest = kBounds;
  double least_m = kInfinity;
  for (const ObstacleIndex i : blockers) {
    if (marked_.contains(i)) return kBounds;
    if (is_ignored(i, query_.ignored)) continue;
    const double clearance_m = blockers.size() == 1 ? 0.0 : clearance(from, to, field_->obstacles()[i]);
    if (clearance_m >= least_m) continue;
    least_m = clearance_m;
    deepest = i;
  }
  return deepest;
}

void VisibilityFront::mark(SharedGraph& graph, ObstacleIndex obstacle) {
  marked_.add(*field_, obstacle);
  const std::size_t targets_before = targets_.size();
  add_samples(graph, obstacle);
  queue_edges_to(targets_before);
}

/// Nothing that stands in the way helps any more: before giving up, the obstacles that never did are sampled as well,
/// those near what was reached first. False when all were marked already.
bool VisibilityFront::mark_rest(SharedGraph& graph) {
  const std::size_t marked_before = marked_.size();
  const std::size_t targets_before = targets_.size();
  bool is_one_left = true;
  for (; is_one_left && marked_.size() == marked_before; rest_within_m_ *= 2.0) {
    is_one_left = false;
    for (ObstacleIndex i = 0; i < field_->size(); ++i) {
      if (marked_.contains(i) || is_ignored(i, query_.ignored)) continue;
      is_one_left = true;
      if (is_near_expanded(field_->obstacles()[i])) marked_.add(*field_, i);
    }
  }
  // Samples come after all marks, so that fewer wait for what covers them.
  for (std::size_t i = marked_before; i < marked_.size(); ++i) add_samples(graph, marked_.list()[i]);
  queue_edges_to(targets_before);
  return marked_.size() > marked_before;
}

bool VisibilityFront::is_near_expanded(const Obstacle& obstacle) const {
  return std::any_of(expanded_.begin(), expanded_.end(),
                     [&](Local node) { return clearance(nodes_[node].position, obstacle) < rest_within_m_; });
}

void VisibilityFront::trace(std::vector<Vec2>& path) const {
  path.clear();
  for (Local node = last_; node != kStart; node = nodes_[node].parent) path.push_back(nodes_[node].position);
  path.push_back(nodes_[kStart].position);
  std::reverse(path.begin(), path.end());
}

}  // namespace regista::graph
