#include "planning/graph/visibility_search.h"

#include <algorithm>
#include <limits>

namespace regista::graph {
namespace {

constexpr std::uint32_t kStart = 0;
constexpr std::uint32_t kGoal = 1;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// How many edges are looked at between two questions whether time is up.
constexpr int kEdgesPerTimeCheck = 64;

/// The list of covering or blocking obstacles as one robot sees it.
bool blocks(std::span<const ObstacleIndex> obstacles, std::span<const std::size_t> ignored) {
  return std::any_of(obstacles.begin(), obstacles.end(), [&](ObstacleIndex i) { return !is_ignored(i, ignored); });
}

}  // namespace

VisibilitySearch::End VisibilitySearch::find(SharedGraph& graph, const Query& query, std::vector<Vec2>& path) {
  clear(graph, query);
  expand(kStart);
  int edges_until_check = kEdgesPerTimeCheck;
  Local nearest = kStart;
  Edge edge{};
  End end = End::no_samples;
  while (next_edge(edge) || (mark_rest(graph) && next_edge(edge))) {
    if (--edges_until_check == 0) {
      if (query.budget.is_spent()) {
        end = End::no_time;
        break;
      }
      edges_until_check = kEdgesPerTimeCheck;
    }
    if (is_covered(graph, edge.to) || !is_open(graph, edge)) continue;
    Node& node = nodes_[edge.to];
    node.cost = edge.from_cost + (node.position - nodes_[edge.from].position).norm();
    node.parent = edge.from;
    if (edge.to == kGoal) {
      trace(kGoal, path);
      return End::goal;
    }
    if (node.heuristic < nodes_[nearest].heuristic) nearest = edge.to;
    expand(edge.to);
  }
  trace(nearest, path);
  return end;
}

void VisibilitySearch::clear(const SharedGraph& graph, const Query& query) {
  ignored_ = query.ignored;
  goal_ = query.goal;
  nodes_.clear();
  expanded_.clear();
  queue_.clear();
  marked_.clear();
  is_marked_.assign(graph.field().size(), 0);
  add_node(query.start, 0);
  add_node(query.goal, 0);
  nodes_[kStart].cost = 0.0;
  for (const Local own : {kStart, kGoal}) nodes_[own].covering_checked = true;
}

void VisibilitySearch::add_node(const Vec2& position, NodeId shared) {
  nodes_.push_back({position, kInfinity, (goal_ - position).norm(), kStart, shared, false, false, false});
}

void VisibilitySearch::queue_edge(Local from, Local to) {
  const Node& target = nodes_[to];
  if (target.covered) return;
  const double from_cost = nodes_[from].cost;
  const double cost = from_cost + (target.position - nodes_[from].position).norm();
  if (cost >= target.cost) return;
  queue_.push_back({cost + target.heuristic, from_cost, from, to});
  std::push_heap(queue_.begin(), queue_.end(), later);
}

bool VisibilitySearch::later(const Edge& a, const Edge& b) {
  if (a.estimate != b.estimate) return a.estimate > b.estimate;
  return a.to != b.to ? a.to > b.to : a.from > b.from;
}

/// Queues all edges from a node that became cheaper (again).
void VisibilitySearch::expand(Local node) {
  if (!nodes_[node].expanded) {
    nodes_[node].expanded = true;
    expanded_.push_back(node);
  }
  for (Local to = kGoal; to < nodes_.size(); ++to) {
    if (to != node) queue_edge(node, to);
  }
}

/// Takes the most promising edge that can still improve its end; false when there is none.
bool VisibilitySearch::next_edge(Edge& edge) {
  while (!queue_.empty()) {
    edge = queue_.front();
    std::pop_heap(queue_.begin(), queue_.end(), later);
    queue_.pop_back();
    const Node& from = nodes_[edge.from];
    const Node& to = nodes_[edge.to];
    if (edge.from_cost > from.cost || to.covered) continue;
    if (edge.from_cost + (to.position - from.position).norm() < to.cost) return true;
  }
  return false;
}

bool VisibilitySearch::is_covered(SharedGraph& graph, Local node) {
  if (!nodes_[node].covering_checked) {
    nodes_[node].covering_checked = true;
    const std::span<const ObstacleIndex> covering = graph.covering(nodes_[node].shared);
    nodes_[node].covered = blocks(covering, ignored_);
    if (nodes_[node].covered) mark(graph, covering);
  }
  return nodes_[node].covered;
}

bool VisibilitySearch::is_open(SharedGraph& graph, const Edge& edge) {
  const Node& from = nodes_[edge.from];
  const Node& to = nodes_[edge.to];
  std::span<const ObstacleIndex> blockers;
  if (edge.from > kGoal && edge.to > kGoal) {
    blockers = graph.blockers(from.shared, to.shared);
  } else {
    blockers_.clear();
    graph.field().blockers(from.position, to.position, blockers_);
    blockers = blockers_;
  }
  if (!blocks(blockers, ignored_)) return true;
  mark(graph, blockers);
  return false;
}

/// Samples those not marked yet and queues the edges from everything expanded to the new nodes.
void VisibilitySearch::mark(SharedGraph& graph, std::span<const ObstacleIndex> obstacles) {
  const std::size_t first_marked = marked_.size();
  for (const ObstacleIndex obstacle : obstacles) {
    if (is_marked_[obstacle] || is_ignored(obstacle, ignored_)) continue;
    is_marked_[obstacle] = 1;
    marked_.push_back(obstacle);
  }
  const Local first_node = static_cast<Local>(nodes_.size());
  for (std::size_t i = first_marked; i < marked_.size(); ++i) {
    const SharedGraph::Samples samples = graph.samples(marked_[i]);
    for (NodeId node = samples.first; node < samples.first + samples.count; ++node) {
      add_node(graph.position(node), node);
    }
  }
  for (const Local from : expanded_) {
    for (Local to = first_node; to < nodes_.size(); ++to) queue_edge(from, to);
  }
}

/// Nothing that stands in the way helps any more: before giving up, the obstacles that never did are sampled as well.
/// False when all were marked already.
bool VisibilitySearch::mark_rest(SharedGraph& graph) {
  blockers_.clear();
  for (ObstacleIndex i = 0; i < is_marked_.size(); ++i) {
    if (!is_marked_[i] && !is_ignored(i, ignored_)) blockers_.push_back(i);
  }
  mark(graph, blockers_);
  return !blockers_.empty();
}

void VisibilitySearch::trace(Local last, std::vector<Vec2>& path) const {
  path.clear();
  for (Local node = last; node != kStart; node = nodes_[node].parent) path.push_back(nodes_[node].position);
  path.push_back(nodes_[kStart].position);
  std::reverse(path.begin(), path.end());
}

}  // namespace regista::graph
