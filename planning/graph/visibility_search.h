// The shortest path over the samples of the obstacles that stand in the way, and of no others.
#pragma once

#include "planning/graph/separation.h"
#include "planning/graph/visibility_front.h"
#include "planning/plan.h"

namespace regista::graph {

/// A front from the start; where that takes long, there may be no way at all, which is proved without any samples, or
/// the goal may lie in a dead end that a front from the goal leaves quickly: then both take turns, and the first to end
/// has the answer. The answer depends on field and query alone. Only scratch memory is kept between two searches.
class VisibilitySearch {
 public:
  enum class End { goal, no_way, no_samples, no_time };

  /// Why the search ended. goal: `path` leads from the start to it. Else `path` leads to the node nearest to the goal
  /// among those reached, and may be the start alone. no_way is a proof; no_samples: not over the samples of the field.
  /// The time is asked for once in 64 edges.
  End find(SharedGraph& graph, const Query& query, std::vector<Vec2>& path);

  /// Obstacles that the front which ended the last search had sampled, in the order in which it marked them.
  std::span<const ObstacleIndex> marked() const { return (is_backward_ ? backward_ : forward_).marked(); }

 private:
  VisibilityFront forward_;
  VisibilityFront backward_;
  Separation separation_;
  bool is_backward_ = false;
};

}  // namespace regista::graph
