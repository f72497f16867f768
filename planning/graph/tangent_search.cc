#include "planning/graph/tangent_search.h"

#include <algorithm>
#include <utility>

namespace regista::graph {
namespace {

using Progress = TangentFront::Progress;

/// Few searches need more; until then the second front would only cost.
constexpr int kLegsAlone = 160;
constexpr int kLegsInTurn = 32;

}  // namespace

TangentSearch::End TangentSearch::find(SharedGraph& graph, const Query& query, std::vector<Vec2>& path) {
  forward_.begin(graph, query);
  Progress progress = forward_.advance(graph, kLegsAlone);
  bool is_backward = false;
  if (progress == Progress::going_on) {
    Query back = query;
    std::swap(back.start, back.goal);
    backward_.begin(graph, back);
  }
  while (progress == Progress::going_on) {
    is_backward = backward_.legs_made() < forward_.legs_made();
    progress = (is_backward ? backward_ : forward_).advance(graph, kLegsInTurn);
  }
  if (progress == Progress::goal && is_backward) {
    backward_.trace(graph, path);
    std::reverse(path.begin(), path.end());
  } else {
    forward_.trace(graph, path);
  }
  if (progress == Progress::no_way) return End::no_way;
  if (progress == Progress::no_time) return End::no_time;
  if (progress == Progress::too_long) return End::too_long;
  const TangentFront& first = is_backward ? backward_ : forward_;
  length_m_ = first.length_m();
  is_path_known_free_ = first.is_path_known_free();
  return End::goal;
}

}  // namespace regista::graph
