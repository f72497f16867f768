// What can be done to a free path without searching: pull it straight, thin it out, and keep following it from where
// the robot is.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planning/obstacle_field.h"
#include "planning/request.h"

namespace regista {

/// From the first point on, always to the last point that is in sight: a path over some of the same points.
std::vector<Vec2> pruned(const ObstacleField& field, std::span<const Vec2> path, std::span<const std::size_t> ignored);

/// A path over some of the same points, of which there is at least one: each leg is drawn out while it is free and all
/// that it leaves out lies within tolerance_m of it.
std::vector<Vec2> thinned(const ObstacleField& field, std::span<const Vec2> path, std::span<const std::size_t> ignored,
                          double tolerance_m);

/// The query's previous path as a path from its start to its goal, passed vertices dropped, if that is free and the
/// goal is where it was or has drifted by less than goal_drift_max_m.
std::optional<std::vector<Vec2>> kept_path(const ObstacleField& field, const Query& query, double goal_drift_max_m);

}  // namespace regista
