// The true shortest path among obstacles by brute force: all tangents, all arcs, Dijkstra. Judge of the planners that
// claim to be optimal or complete; of planning it knows the definition of an obstacle and clearance.h alone.
#pragma once

#include <optional>
#include <span>

#include "planning/obstacle_field.h"

namespace regista::testing {

/// Length in metres of the shortest path of a point from `start` to `goal`, both free, within the bounds and around all
/// obstacles that are not in `ignored`; nothing when there is no path. Touching is free (kTouch_m), so a path may slip
/// between two obstacles that touch exactly. Worlds whose answer hangs on overlaps of 1 to 2 kTouch_m are undecided.
/// Takes time proportional to the obstacles' number to the third power.
std::optional<double> exact_shortest_length(const ObstacleField& field, const Vec2& start, const Vec2& goal,
                                            std::span<const std::size_t> ignored = {});

}  // namespace regista::testing
