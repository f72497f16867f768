// The visibility-sampling graph of one team and frame, grown lazily by its robots' searches. It memoises pure functions
// of the frame's field (the samples of an obstacle, what covers a sample, what blocks an edge), so it makes searches
// faster and cannot change their answers. While nothing moves it is kept from frame to frame.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planning/graph/bodies.h"
#include "planning/graph/contacts.h"
#include "planning/graph/edge_memo.h"
#include "planning/graph/graph_picture.h"
#include "planning/graph/samples.h"
#include "planning/graph/separation.h"
#include "planning/obstacle_field.h"

namespace regista::graph {

/// A sample point: kSamplesMax times its obstacle's index plus its place among the samples of that obstacle. The same
/// in every graph of the same field, whatever was asked before.
using NodeId = std::uint32_t;

class SharedGraph {
 public:
  SharedGraph() = default;
  explicit SharedGraph(ObstacleField field) { reset(std::move(field)); }

  /// Begins a new frame, keeping the memory, and what is known when nothing has moved. Throws as ObstacleField does.
  void reset(const Bounds& bounds, std::span<const Obstacle> obstacles);
  void reset(ObstacleField field);

  /// Forgets the field and all that follows from it, so that the next frame is built from nothing; keeps the memory.
  void clear();

  const ObstacleField& field() const { return field_; }

  /// The samples of an obstacle: nodes first … first + count - 1.
  struct Samples {
    NodeId first = 0;
    std::uint32_t count = 0;
  };
  Samples samples(ObstacleIndex obstacle);

  /// Valid for nodes that samples() has returned.
  const Vec2& position(NodeId node) const { return nodes_[node].position; }

  /// Obstacles that cover a sample / block the edge between two samples, by index, for nodes that samples() has
  /// returned. The span is valid until the graph is asked again.
  std::span<const ObstacleIndex> covering(NodeId node) const { return list(nodes_[node].covering); }
  std::span<const ObstacleIndex> blockers(NodeId from, NodeId to);

  /// The boundary of an obstacle. Valid until the next frame.
  const Body& body(ObstacleIndex obstacle) { return bodies_.of(field_, obstacle); }

  /// Where the boundary of an obstacle cannot be run along. Valid until the graph is asked again.
  Contacts::Of contacts(ObstacleIndex obstacle) { return contacts_.of(field_, obstacle, body(obstacle)); }

  /// All pairs of obstacles that overlap. Valid until the next frame.
  std::span<const Overlap> overlaps();

  /// For the picture: a search has tested that leg against all obstacles.
  void note_leg(const Vec2& from, const Vec2& to, bool is_blocked) {
    if (legs_.size() < kLegsInPicture) legs_.push_back({from, to, is_blocked});
  }

  /// What has been evaluated since the field last changed, and the legs of this frame, each as far as they fit;
  /// captured, team and sequence are left to the caller.
  GraphPicture picture() const;

 private:
  struct Node {
    Vec2 position = Vec2::Zero();
    BlockerList covering;
  };
  struct Leg {
    Vec2 from, to;
    bool is_blocked = false;
  };
  static constexpr std::size_t kLegsInPicture = kEdgesInPicture / 2;

  static constexpr std::uint8_t kUnknown = 0xFF;

  std::span<const ObstacleIndex> list(BlockerList blockers) const {
    return {arena_.data() + blockers.begin, blockers.count};
  }

  /// The arena from `begin` to its end.
  BlockerList list_from(std::size_t begin) const {
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(arena_.size() - begin)};
  }

  bool is_same_field(const Bounds& bounds, std::span<const Obstacle> obstacles) const;
  void forget();
  void sample(ObstacleIndex obstacle);

  ObstacleField field_;
  Bodies bodies_;
  Contacts contacts_;
  std::vector<std::uint8_t> sample_counts_;  ///< by obstacle, or kUnknown
  std::vector<Node> nodes_;                  ///< by NodeId; of no meaning where the obstacle was not sampled
  EdgeMemo edges_;
  std::vector<Overlap> overlaps_;
  bool overlaps_known_ = false;
  std::vector<Leg> legs_;
  std::vector<ObstacleIndex> arena_;       ///< all lists of blockers, one after the other
  std::vector<ObstacleIndex> neighbours_;  ///< scratch
  std::vector<Vec2> samples_;              ///< scratch
};

}  // namespace regista::graph
