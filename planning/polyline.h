// What can be done to a free path without searching: pull it straight, and keep following it from where the robot is.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planning/obstacle_field.h"
#include "planning/request.h"

namespace regista {

/// From the first point on, always to the last point that is in sight: a path over some of the same points.
std::vector<Vec2> pruned(const ObstacleField& field, std::span<const Vec2> path, std::span<const std::size_t> ignored);

/// The query's previous path as a path from its start to its goal, passed vertices dropped, if that is free and the
/// goal is where it was or has drifted by less than goal_drift_max_m.
std::optional<std::vector<Vec2>> kept_path(const ObstacleField& field, const Query& query, double goal_drift_max_m);

}  // namespace regista
