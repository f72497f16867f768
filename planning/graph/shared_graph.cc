#include "planning/graph/shared_graph.h"

#include <algorithm>
#include <bit>

namespace regista::graph {
namespace {

/// To the bit: 0 and -0 are equal, but not in what follows from them.
bool is_same(double one, double other) {
  return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}
bool is_same(const Vec2& one, const Vec2& other) { return is_same(one.x(), other.x()) && is_same(one.y(), other.y()); }
bool is_same(const Obstacle& one, const Obstacle& other) {
  return one.core == other.core && is_same(one.a, other.a) && is_same(one.b, other.b) &&
         is_same(one.radius_m, other.radius_m);
}

}  // namespace

void SharedGraph::reset(const Bounds& bounds, std::span<const Obstacle> obstacles) {
  legs_.clear();
  if (is_same_field(bounds, obstacles)) return;
  field_.assign(bounds, obstacles);
  forget();
}

void SharedGraph::reset(ObstacleField field) {
  legs_.clear();
  if (is_same_field(field.bounds(), field.obstacles())) return;
  field_ = std::move(field);
  forget();
}

void SharedGraph::clear() {
  legs_.clear();
  field_.assign({}, {});
  forget();
}

bool SharedGraph::is_same_field(const Bounds& bounds, std::span<const Obstacle> obstacles) const {
  const std::span<const Obstacle> known = field_.obstacles();
  return is_same(bounds.half_extent_m, field_.bounds().half_extent_m) &&
         std::equal(known.begin(), known.end(), obstacles.begin(), obstacles.end(),
                    [](const Obstacle& one, const Obstacle& other) { return is_same(one, other); });
}

void SharedGraph::forget() {
  bodies_.reset(field_.size());
  contacts_.reset(field_.size());
  sample_counts_.assign(field_.size(), kUnknown);
  edges_.clear();
  overlaps_.clear();
  overlaps_known_ = false;
  arena_.clear();
}

SharedGraph::Samples SharedGraph::samples(ObstacleIndex obstacle) {
  if (sample_counts_[obstacle] == kUnknown) sample(obstacle);
  return {static_cast<NodeId>(obstacle * kSamplesMax), sample_counts_[obstacle]};
}

void SharedGraph::sample(ObstacleIndex obstacle) {
  if (nodes_.size() < field_.size() * kSamplesMax) nodes_.resize(field_.size() * kSamplesMax);
  neighbours_.clear();
  samples_.clear();
  field_.visit_maybe_near(obstacle, samples_reach_m(field_.obstacles()[obstacle].radius_m),
                          [this](ObstacleIndex i) { neighbours_.push_back(i); });
  append_samples(field_, obstacle, neighbours_, samples_);
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    const std::size_t begin = arena_.size();
    for (const ObstacleIndex other : neighbours_) {
      if (!is_free(samples_[k], samples_[k], field_.obstacles()[other])) arena_.push_back(other);
    }
    nodes_[obstacle * kSamplesMax + k] = {samples_[k], list_from(begin)};
  }
  sample_counts_[obstacle] = static_cast<std::uint8_t>(samples_.size());
}

std::span<const ObstacleIndex> SharedGraph::blockers(NodeId from, NodeId to) {
  if (const BlockerList* known = edges_.find(from, to)) return list(*known);
  const std::size_t begin = arena_.size();
  // From the smaller to the larger number: rounding must not depend on who asks.
  field_.blockers(nodes_[std::min(from, to)].position, nodes_[std::max(from, to)].position, arena_);
  const BlockerList found = list_from(begin);
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
  for (std::size_t obstacle = 0; obstacle < sample_counts_.size(); ++obstacle) {
    if (sample_counts_[obstacle] == kUnknown) continue;
    for (std::size_t k = 0; k < sample_counts_[obstacle]; ++k) {
      const std::size_t node = obstacle * kSamplesMax + k;
      drawn[node] = static_cast<std::uint32_t>(picture.nodes.size());
      picture.nodes.push_back(nodes_[node].position);
    }
  }
  edges_.for_each([&](NodeId from, NodeId to, BlockerList blockers) {
    picture.edges.push_back({drawn[from], drawn[to], blockers.count > 0});
  });
  std::sort(picture.edges.begin(), picture.edges.end(),
            [](const GraphEdge& a, const GraphEdge& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; });
  picture.edges.resize(std::min(picture.edges.size(), kEdgesInPicture - legs_.size()));
  for (const Leg& leg : legs_) {
    const auto node = static_cast<std::uint32_t>(picture.nodes.size());
    picture.nodes.push_back(leg.from);
    picture.nodes.push_back(leg.to);
    picture.edges.push_back({node, node + 1, leg.is_blocked});
  }
  return picture;
}

}  // namespace regista::graph
