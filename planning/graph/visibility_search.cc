#include "planning/graph/visibility_search.h"

#include <algorithm>
#include <utility>

namespace regista::graph {
namespace {

using Progress = VisibilityFront::Progress;

/// Few searches need more; until then a proof and a second front would only cost, and later too, mostly.
constexpr int kEdgesAlone = 128;
constexpr int kEdgesForward = 192;
constexpr int kEdgesBackward = 64;

}  // namespace

VisibilitySearch::End VisibilitySearch::find(SharedGraph& graph, const Query& query, std::vector<Vec2>& path) {
  is_backward_ = false;
  forward_.begin(graph, query);
  Progress progress = forward_.advance(graph, kEdgesAlone);
  if (progress == Progress::going_on) {
    if (separation_.separates(graph.field(), graph.overlaps(), query.start, query.goal, query.ignored)) {
      forward_.trace(path);
      return End::no_way;
    }
    Query back = query;
    std::swap(back.start, back.goal);
    backward_.begin(graph, back);
  }
  while (progress == Progress::going_on) {
    is_backward_ = !is_backward_;
    progress = is_backward_ ? backward_.advance(graph, kEdgesBackward) : forward_.advance(graph, kEdgesForward);
  }
  if (progress == Progress::goal && is_backward_) {
    backward_.trace(path);
    std::reverse(path.begin(), path.end());
  } else {
    forward_.trace(path);
  }
  if (progress == Progress::goal) return End::goal;
  return progress == Progress::no_time ? End::no_time : End::no_samples;
}

}  // namespace regista::graph
