// An arc along a boundary as a polyline that can be driven and checked: circumscribed, so that it stays outside.
#pragma once

#include <vector>

#include "planning/graph/shared_graph.h"

namespace regista::graph {

struct Arc {
  Place from;
  Place to;
  double side = 1.0;  ///< 1: counter-clockwise
};

/// Appends the vertices of the arc's polyline, at most kArcExcess longer. Its legs touch the arc, the first where it
/// begins and the last where it ends, and where another obstacle is so near that a vertex would lie in it. Returns
/// what is near: all that the polyline can meet. Valid until the graph is asked again.
Contacts::Of append_arc(SharedGraph& graph, ObstacleIndex obstacle, const Body& body, const Arc& arc,
                        std::vector<Vec2>& path);

/// The polyline is free of what is near and not ignored.
bool is_clear_of(const ObstacleField& field, const Contacts::Of& near, std::span<const Vec2> polyline,
                 std::span<const std::size_t> ignored);

}  // namespace regista::graph
