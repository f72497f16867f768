#include "planning/graph/shared_graph.h"

#include "planning/graph/samples.h"

namespace regista::graph {

void SharedGraph::reset(const Bounds& bounds, std::span<const Obstacle> obstacles) {
  field_.assign(bounds, obstacles);
  forget();
}

void SharedGraph::reset(ObstacleField field) {
  field_ = std::move(field);
  forget();
}

void SharedGraph::forget() {
  contacts_.reset(field_.size());
  edges_.clear();
  overlaps_.clear();
  overlaps_known_ = false;
  legs_.clear();
  arena_.clear();
  sampled_.clear();
}

void SharedGraph::number_samples() {
  sampled_.assign(field_.size(), Sampled{});
  NodeId next = 0;
  for (std::size_t i = 0; i < field_.size(); ++i) {
    sampled_[i].first = next;
    next += static_cast<NodeId>(samples_max(field_.obstacles()[i]));
  }
  nodes_.assign(next, Node{});
}

SharedGraph::Samples SharedGraph::samples(ObstacleIndex obstacle) {
  if (sampled_.empty()) number_samples();
  Sampled& sampled = sampled_[obstacle];
  if (!sampled.known) {
    scratch_.clear();
    append_samples(field_, obstacle, scratch_);
    sampled.count = static_cast<std::uint32_t>(scratch_.size());
    for (std::uint32_t k = 0; k < sampled.count; ++k) nodes_[sampled.first + k].position = scratch_[k];
    sampled.known = true;
  }
  return {sampled.first, sampled.count};
}

std::span<const ObstacleIndex> SharedGraph::covering(NodeId node) {
  Node& n = nodes_[node];
  if (!n.covering_known) {
    const std::size_t begin = arena_.size();
    field_.covering(n.position, arena_);
    n.covering = {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(arena_.size() - begin)};
    n.covering_known = true;
  }
  return list(n.covering);
}

std::span<const ObstacleIndex> SharedGraph::blockers(NodeId from, NodeId to) {
  if (const BlockerList* known = edges_.find(from, to)) return list(*known);
  const std::size_t begin = arena_.size();
  // From the smaller to the larger number: rounding must not depend on who asks.
  field_.blockers(nodes_[std::min(from, to)].position, nodes_[std::max(from, to)].position, arena_);
  const BlockerList found{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(arena_.size() - begin)};
  edges_.insert(from, to, found);
  return list(found);
}

std::span<const Overlap> SharedGraph::overlaps() {
  if (!overlaps_known_) append_overlaps(field_, overlaps_);
  overlaps_known_ = true;
  return overlaps_;
}

GraphPicture SharedGraph::picture() const {
  GraphPicture picture;
  std::vector<std::uint32_t> drawn(nodes_.size(), 0);
  for (const Sampled& sampled : sampled_) {
    if (!sampled.known) continue;
    for (NodeId node = sampled.first; node < sampled.first + sampled.count; ++node) {
      drawn[node] = static_cast<std::uint32_t>(picture.nodes.size());
      picture.nodes.push_back(nodes_[node].position);
    }
  }
  edges_.for_each([&](NodeId from, NodeId to, BlockerList blockers) {
    picture.edges.push_back({drawn[from], drawn[to], blockers.count > 0});
  });
  std::sort(picture.edges.begin(), picture.edges.end(),
            [](const GraphEdge& a, const GraphEdge& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; });
  for (const Leg& leg : legs_) {
    const auto node = static_cast<std::uint32_t>(picture.nodes.size());
    picture.nodes.push_back(leg.from);
    picture.nodes.push_back(leg.to);
    picture.edges.push_back({node, node + 1, leg.is_blocked});
  }
  return picture;
}

}  // namespace regista::graph
