// DVG+A* exactly as Costa & Tonidandel describe it (section 3), for the reproduction of their tables. Its objects are
// octagons that cut the corners of real keep-out circles and its last edge may enter one, so a robot that drives uses
// dvg.h.
#pragma once

#include "planning/planners/dvg_graph.h"
#include "planning/planners/dvg_objects.h"

namespace regista::dvg {

/// r of section 3.1, metres.
inline constexpr double kRobotObject_m = 0.24;
inline constexpr double kBallObject_m = 0.3;

struct Result {
  End end = End::no_way;
  /// From start to goal; else to the node nearest to the goal that could be reached.
  std::vector<Vec2> path;
  std::size_t objects = 0;  ///< in the active region, groups counted as one
  std::size_t nodes = 0;
  std::size_t edges = 0;
};

/// Objects grow and group as `params` say, those that reach into the active region count, nothing else does: there are
/// no bounds. What blocks:
/// - an edge: a point within an octagon; but
/// - an edge to the goal, of an object that covers the goal: coming nearer to its centre than robot_radius_m ("special
///   condition"; exception_everywhere: of every object);
/// - an edge from the start, of an object that covers the start, of which the paper says nothing: coming nearer to its
///   centre than that, or than the start is.
/// Memory of `graph` is used again.
void find(std::span<const Object> objects, const Vec2& start, const Vec2& goal, const DvgParams& params, Graph& graph,
          Result& result, const Budget& budget = {});

}  // namespace regista::dvg
