// How a visibility search goes on from a node: the edges that wait, those that are looked at next, and whether one is
// free.
#include <algorithm>
#include <utility>

#include "planning/graph/visibility_front.h"

namespace regista::graph {
namespace {

/// No edge has been queued yet; shorter than any estimate.
constexpr double kNothingDone_m = -1.0;

}  // namespace

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

/// From everything expanded to the new targets.
void VisibilityFront::queue_edges_to(std::size_t first_target) {
  for (const Local from : expanded_) {
    for (std::size_t i = first_target; i < targets_.size(); ++i) queue_edge(from, targets_[i], kNothingDone_m);
  }
}

/// Queues the edge where it may shorten the way to its end by now; edges whose estimate is `done_m` or less have been.
void VisibilityFront::queue_edge(Local from, Local to, double done_m) {
  const Node& source = nodes_[from];
  Node& target = nodes_[to];
  if (target.cost <= source.cost) return;
  const Vec2 way = target.position - source.position;
  const double length_m = way.norm();
  const double cost = source.cost + length_m;
  if (cost >= target.cost) return;
  const double estimate = cost + least_to_goal_m(target);
  if (estimate <= done_m) return;
  if (estimate > limit_m_) {
    least_beyond_m_ = std::min(least_beyond_m_, estimate);
    return;
  }
  const Vec2 along = length_m > 0.0 ? Vec2(way / length_m) : Vec2::Zero();
  if (!is_free_of_marked({source.position, target.position, along})) return;
  queue_.push({estimate, static_cast<std::uint32_t>(edges_.size()), false});
  edges_.push_back({cost, from, to, static_cast<std::uint32_t>(marked_.size())});
}

/// No way from there is shorter, as far as single marked obstacles show.
double VisibilityFront::least_to_goal_m(Node& node) {
  if (node.bound_by == marked_.size() || node.covered_by != kBounds) return node.least_m;
  for (std::size_t slot = detours_.size(); slot < marked_.size(); ++slot) {
    detours_.add(field_->obstacles()[marked_.list()[slot]], field_->bounds());
  }
  const double least_m = detours_.least_m(node.position, query_.goal, node.bound_by);
  node.bound_by = static_cast<std::uint32_t>(marked_.size());
  // Where no way leads on, the nearest place is looked for all the same.
  if (least_m < kInfinity) node.least_m = std::max(node.least_m, least_m);
  return node.least_m;
}

/// A covered sample is of no use any more once what covers it is marked.
void VisibilityFront::drop_void_targets() {
  if (marked_.size() == targets_checked_at_) return;
  targets_checked_at_ = marked_.size();
  std::erase_if(targets_, [this](Local node) { return is_void(nodes_[node]); });
}

/// Takes the most promising edge that can still improve its end; null when there is none in the queue.
const VisibilityFront::Edge* VisibilityFront::next_edge() {
  while (!queue_.is_empty()) {
    const SearchQueue::Entry entry = queue_.pop();
    const Edge& edge = edges_[entry.index];
    Node& to = nodes_[edge.to];
    if (edge.cost >= to.cost || is_void(to)) continue;
    const double estimate = edge.cost + least_to_goal_m(to);
    if (estimate <= entry.estimate_m + kPutOff_m) return &edge;
    if (estimate <= limit_m_) {
      queue_.push({estimate, entry.index, false});
    } else {
      least_beyond_m_ = std::min(least_beyond_m_, estimate);
    }
  }
  return nullptr;
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

/// Nothing blocks the edge; else what does is marked.
bool VisibilityFront::is_open(SharedGraph& graph, const Edge& edge) {
  const Node& from = nodes_[edge.from];
  const Node& to = nodes_[edge.to];
  // Most edges that fail have failed by now; the others show what else has to be gone round.
  if (edge.free_of < marked_.size()) {
    const Vec2 along = (to.position - from.position).normalized();
    if (!is_free_of_marked({from.position, to.position, along})) return false;
  }
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

/// What blocked an edge blocks its neighbours as well: all edges share their occluders.
bool VisibilityFront::is_free_of_marked(const ObstacleBoxes::Motion& motion) {
  if (marked_.is_few() && occluders_.surely_block(motion)) return false;
  return marked_.are_clear_of(*field_, motion, BlockerSet::kNone, BlockerSet::kNone, occluders_);
}

}  // namespace regista::graph
