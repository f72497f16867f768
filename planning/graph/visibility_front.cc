#include "planning/graph/visibility_front.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace regista::graph {
namespace {

constexpr std::uint32_t kStart = 0;
constexpr std::uint32_t kGoal = 1;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr int kEdgesPerTimeCheck = 64;

/// No edge has been queued yet; shorter than any estimate.
constexpr double kNothingDone_m = -1.0;

/// Edges whose way is longer wait outside of the queue: at first by that share and length more than the straight line,
/// later by that share more than what is needed.
constexpr double kDetour = 1.15;
constexpr double kDetour_m = 0.1;

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
  queue_.clear();
  marked_.clear();
  marked_boxes_.clear();
  is_marked_.assign(field_->size(), 0);
  recent_ = kBounds;
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
  Edge edge{};
  for (const int end = edges_tested_ + edges; edges_tested_ < end;) {
    if (!next_edge(edge)) {
      if (!widen() && !mark_rest(graph)) return Progress::no_samples;
      if (query_.budget.is_spent()) return Progress::no_time;
      continue;
    }
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
    if (node.heuristic < nodes_[last_].heuristic) last_ = edge.to;
    expand(edge.to);
  }
  return Progress::going_on;
}

void VisibilityFront::add_node(const Vec2& position, NodeId shared, ObstacleIndex covered_by) {
  targets_.push_back(static_cast<Local>(nodes_.size()));
  nodes_.push_back({position, kInfinity, (query_.goal - position).norm(), kStart, shared, covered_by, false});
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

/// Queues the edge where it may shorten the way to its end by now; edges whose estimate is `done_m` or less have been.
void VisibilityFront::queue_edge(Local from, Local to, double done_m) {
  const Node& source = nodes_[from];
  const Node& target = nodes_[to];
  if (target.cost <= source.cost) return;
  const double cost = source.cost + (target.position - source.position).norm();
  const double estimate = cost + target.heuristic;
  if (cost >= target.cost || estimate <= done_m) return;
  if (estimate > limit_m_) {
    least_beyond_m_ = std::min(least_beyond_m_, estimate);
    return;
  }
  if (!is_free_of_marked(source.position, target.position)) return;
  queue_.push_back({estimate, cost, from, to, static_cast<std::uint32_t>(marked_.size())});
  std::push_heap(queue_.begin(), queue_.end(), later);
}

bool VisibilityFront::later(const Edge& a, const Edge& b) {
  if (a.estimate != b.estimate) return a.estimate > b.estimate;
  return a.to != b.to ? a.to > b.to : a.from > b.from;
}

/// Queues all edges from a node that became cheaper (again).
void VisibilityFront::expand(Local node) {
  if (!nodes_[node].is_expanded) {
    nodes_[node].is_expanded = true;
    expanded_.push_back(node);
  }
  drop_void_targets();
  for (const Local to : targets_) {
    if (to != node) queue_edge(node, to, kNothingDone_m);
  }
}

/// A covered sample is of no use any more once what covers it is marked.
void VisibilityFront::drop_void_targets() {
  if (marked_.size() == targets_checked_at_) return;
  targets_checked_at_ = marked_.size();
  std::erase_if(targets_, [this](Local node) { return is_void(nodes_[node]); });
}

/// Takes the most promising edge that can still improve its end; false when there is none in the queue.
bool VisibilityFront::next_edge(Edge& edge) {
  while (!queue_.empty()) {
    edge = queue_.front();
    std::pop_heap(queue_.begin(), queue_.end(), later);
    queue_.pop_back();
    const Node& to = nodes_[edge.to];
    if (edge.cost < to.cost && !is_void(to)) return true;
  }
  return false;
}

/// Queues the edges that have waited for a longer way to be needed; false when there are none.
bool VisibilityFront::widen() {
  if (least_beyond_m_ == kInfinity) return false;
  const double done_m = std::exchange(limit_m_, kDetour * least_beyond_m_);
  least_beyond_m_ = kInfinity;
  drop_void_targets();
  for (const Local from : expanded_) {
    for (const Local to : targets_) {
      if (to != from) queue_edge(from, to, done_m);
    }
  }
  return true;
}

/// Marked obstacles alone.
bool VisibilityFront::is_free_of_marked(const Vec2& from, const Vec2& to) {
  // What blocked an edge blocks its neighbours as well.
  if (recent_ != kBounds) {
    const Obstacle& obstacle = field_->obstacles()[recent_];
    if (!is_free(from, to, obstacle)) return false;
  }
  bool is_blocked = false;
  marked_boxes_.visit_near(from, to, 0.0, [&](ObstacleIndex i) {
    const Obstacle& obstacle = field_->obstacles()[i];
    is_blocked = !is_free(from, to, obstacle);
    if (is_blocked) recent_ = i;
    return is_blocked;
  });
  return !is_blocked;
}

/// Nothing blocks the edge; else what does is marked.
bool VisibilityFront::is_open(SharedGraph& graph, const Edge& edge) {
  const Node& from = nodes_[edge.from];
  const Node& to = nodes_[edge.to];
  // Most edges that fail have failed by now; the others show what else has to be gone round.
  if (edge.free_of < marked_.size() && !is_free_of_marked(from.position, to.position)) return false;
  std::span<const ObstacleIndex> blockers;
  if (edge.from > kGoal && edge.to > kGoal) {
    blockers = graph.blockers(from.shared, to.shared);
  } else {
    blockers_.clear();
    field_->blockers(from.position, to.position, blockers_);
    blockers = blockers_;
  }
  if (!blocks_one(blockers)) return true;
  const ObstacleIndex worth = worth_marking(from.position, to.position, blockers);
  if (worth != kBounds) mark(graph, worth);
  return false;
}

ObstacleIndex VisibilityFront::worth_marking(const Vec2& from, const Vec2& to,
                                             std::span<const ObstacleIndex> blockers) const {
  ObstacleIndex deepest = kBounds;
  double least_m = kInfinity;
  for (const ObstacleIndex i : blockers) {
    if (is_marked_[i] != 0) return kBounds;
    if (is_ignored(i, query_.ignored)) continue;
    const double clearance_m = blockers.size() == 1 ? 0.0 : clearance(from, to, field_->obstacles()[i]);
    if (clearance_m >= least_m) continue;
    least_m = clearance_m;
    deepest = i;
  }
  return deepest;
}

void VisibilityFront::mark(SharedGraph& graph, ObstacleIndex obstacle) {
  add_to_marked(obstacle);
  const std::size_t targets_before = targets_.size();
  add_samples(graph, obstacle);
  queue_edges_to(targets_before);
}

void VisibilityFront::add_to_marked(ObstacleIndex obstacle) {
  is_marked_[obstacle] = 1;
  marked_.push_back(obstacle);
  marked_boxes_.append(field_->obstacles()[obstacle], obstacle);
}

/// From everything expanded to the new targets.
void VisibilityFront::queue_edges_to(std::size_t first_target) {
  for (const Local from : expanded_) {
    for (std::size_t i = first_target; i < targets_.size(); ++i) queue_edge(from, targets_[i], kNothingDone_m);
  }
}

/// Nothing that stands in the way helps any more: before giving up, the obstacles that never did are sampled as well,
/// those near what was reached first. False when all were marked already.
bool VisibilityFront::mark_rest(SharedGraph& graph) {
  const std::size_t marked_before = marked_.size();
  const std::size_t targets_before = targets_.size();
  bool is_one_left = true;
  for (; is_one_left && marked_.size() == marked_before; rest_within_m_ *= 2.0) {
    is_one_left = false;
    for (ObstacleIndex i = 0; i < is_marked_.size(); ++i) {
      if (is_marked_[i] != 0 || is_ignored(i, query_.ignored)) continue;
      is_one_left = true;
      if (is_near_expanded(field_->obstacles()[i])) add_to_marked(i);
    }
  }
  // Samples come after all marks, so that fewer wait for what covers them.
  for (std::size_t i = marked_before; i < marked_.size(); ++i) add_samples(graph, marked_[i]);
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
