// Slow and simple answers to what planning answers fast: dense sampling and exhaustive search. Independent of
// ObstacleField and of the graph.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planning/obstacle_field.h"
#include "planning/plan.h"
#include "planning/request.h"

namespace regista::testing {

/// Points all along the obstacle's boundary, neighbours at most step_m apart.
std::vector<Vec2> boundary_points(const Obstacle& obstacle, double step_m);

/// Signed distance by the nearest of the boundary points and a sign from the definition of the obstacle; too large by
/// less than step_m, never too small in magnitude.
double sampled_clearance(const Vec2& point, const Obstacle& obstacle, double step_m);

/// By asking every obstacle in turn.
bool point_is_free(const ObstacleField& field, const Vec2& point, std::span<const std::size_t> ignored);
bool segment_is_free(const ObstacleField& field, const Vec2& from, const Vec2& to,
                     std::span<const std::size_t> ignored);

/// What is wrong with an answer of status ok, by the laws in planner.h; empty when nothing is.
std::string fault_of(const ObstacleField& field, const PlanRequest& request, const Plan& plan);

/// Length of the shortest path from the first to the second node over all free edges, by Dijkstra on the full graph.
std::optional<double> shortest_length(const ObstacleField& field, const std::vector<Vec2>& nodes,
                                      std::span<const std::size_t> ignored);

}  // namespace regista::testing
