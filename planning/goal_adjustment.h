// Covered starts and goals: the nearest free point, and the shortest straight way out. Exact: candidates are all places
// where the nearest point can be, tried in order of distance.
#pragma once

#include <optional>
#include <span>

#include "planning/obstacle_field.h"

namespace regista {

/// The free point nearest to `point` (itself when free): inside the bounds, in no obstacle but ignored ones. Nothing
/// when there is none at all.
std::optional<Vec2> nearest_free_point(const ObstacleField& field, const Vec2& point,
                                       std::span<const std::size_t> ignored = {});

/// The free point nearest to `start` that a straight leg reaches while crossing only obstacles that cover the start;
/// the outside of the bounds counts as covering a start that lies there. Nothing when there is none.
std::optional<Vec2> way_out(const ObstacleField& field, const Vec2& start, std::span<const std::size_t> ignored = {});

}  // namespace regista
