#include "planning/planners/dvg_graph.h"

#include <algorithm>
#include <limits>

#include "planning/clearance.h"

namespace regista::dvg {
namespace {

constexpr std::uint32_t kStart = 0;
constexpr std::uint32_t kGoal = 1;

}  // namespace

bool Graph::build(std::span<const Polygon> polygons, const Vec2& start, const Vec2& goal, bool edge_limit,
                  const IsFree& is_free, const Budget& budget) {
  nodes_.clear();
  edge_count_ = 0;
  add_node(start, start, false);
  add_node(goal, goal, false);
  connect(kStart, kGoal, is_free);
  for (const Polygon& polygon : polygons) {
    for (const Vec2& corner : polygon.vertices()) {
      if (!is_free(corner, corner, Edge::between_corners)) continue;
      if (budget.is_spent()) return false;
      add_node(corner, polygon.centre, edge_limit && polygon.is_disc);
      const Index node = static_cast<Index>(nodes_.size() - 1);
      for (Index earlier = 0; earlier < node; ++earlier) connect(earlier, node, is_free);
    }
  }
  return true;
}

void Graph::add_node(const Vec2& position, const Vec2& centre, bool is_limited) {
  nodes_.push_back({position, centre, is_limited, 0.0, kStart, false});
  if (links_.size() < nodes_.size()) links_.emplace_back();
  links_[nodes_.size() - 1].clear();
}

void Graph::connect(Index one, Index other, const IsFree& is_free) {
  const Node& a = nodes_[one];
  const Node& b = nodes_[other];
  const double length_m = (b.position - a.position).norm();
  // Tangents of objects of one size are exactly as long as the centres are apart; rounding must not drop them.
  if (a.is_limited && b.is_limited && length_m < (b.centre - a.centre).norm() - kTouch_m) return;
  const bool free = one == kGoal     ? is_free(b.position, a.position, Edge::to_goal)
                    : other == kGoal ? is_free(a.position, b.position, Edge::to_goal)
                    : one == kStart  ? is_free(a.position, b.position, Edge::from_start)
                                     : is_free(a.position, b.position, Edge::between_corners);
  if (!free) return;
  links_[one].push_back({other, length_m});
  links_[other].push_back({one, length_m});
  ++edge_count_;
}

bool Graph::later(const Open& a, const Open& b) {
  return a.estimate != b.estimate ? a.estimate > b.estimate : a.node > b.node;
}

bool Graph::shortest_path(std::vector<Vec2>& path) {
  for (Node& node : nodes_) {
    node.cost = std::numeric_limits<double>::infinity();
    node.closed = false;
  }
  const Vec2 goal = nodes_[kGoal].position;
  const auto to_goal_m = [&](Index node) { return (goal - nodes_[node].position).norm(); };
  nodes_[kStart].cost = 0.0;
  open_.assign(1, {to_goal_m(kStart), kStart});
  Index nearest = kStart;
  while (!open_.empty()) {
    const Index at = open_.front().node;
    std::pop_heap(open_.begin(), open_.end(), later);
    open_.pop_back();
    if (nodes_[at].closed) continue;
    nodes_[at].closed = true;
    if (to_goal_m(at) < to_goal_m(nearest)) nearest = at;
    if (at == kGoal) break;
    for (const Link& link : links_[at]) {
      Node& next = nodes_[link.to];
      const double cost = nodes_[at].cost + link.length_m;
      if (cost >= next.cost) continue;
      next.cost = cost;
      next.parent = at;
      open_.push_back({cost + to_goal_m(link.to), link.to});
      std::push_heap(open_.begin(), open_.end(), later);
    }
  }
  const bool found = nodes_[kGoal].closed;
  trace(found ? kGoal : nearest, path);
  return found;
}

void Graph::trace(Index last, std::vector<Vec2>& path) const {
  path.clear();
  for (Index node = last; node != kStart; node = nodes_[node].parent) path.push_back(nodes_[node].position);
  path.push_back(nodes_[kStart].position);
  std::reverse(path.begin(), path.end());
}

}  // namespace regista::dvg
