// The true shortest path of a point around discs, capsules and rounded rectangles. The limit of visibility sampling for
// infinitely many samples.
#pragma once

#include "planning/graph/tangent_front.h"

namespace regista::graph {

/// A front from the start; where that takes long, the goal may lie in a dead end that a front from the goal leaves
/// quickly: then the one that has cost less goes on, and the first to end has the answer. The answer depends on field
/// and query alone. Only scratch memory is kept between two searches.
class TangentSearch {
 public:
  enum class End { goal, no_way, no_time, too_long };

  /// Why the search ended. goal: `path` leads from the start to it, arcs as circumscribed polylines at most kArcExcess
  /// longer. Else `path` leads to the arrival nearest to the goal, and may be the start alone. no_way is a proof.
  /// The time is asked for once in 64 steps of a front.
  End find(SharedGraph& graph, const Query& query, std::vector<Vec2>& path);

  /// Exact length of the last search's way to the goal, arcs as arcs. Metres.
  double length_m() const { return length_m_; }

  /// All of the last search's path to the goal is free by clearance.h; false: nobody knows.
  bool is_path_known_free() const { return is_path_known_free_; }

  /// Obstacles the front from the start went round, or tried to, in the order in which they became active.
  std::span<const ObstacleIndex> active() const { return forward_.active(); }

 private:
  TangentFront forward_;
  TangentFront backward_;
  double length_m_ = 0.0;
  bool is_path_known_free_ = false;
};

}  // namespace regista::graph
