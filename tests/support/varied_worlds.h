// Random worlds that try out every shape and every kind of overlap, smaller and more varied than a match is; and how to
// show one that went wrong.
#pragma once

#include <random>
#include <string>

#include "planning/obstacle_field.h"
#include "planning/request.h"

namespace regista::testing {

/// Discs, capsules and rectangles of all sizes, some without radius, some twice, some touching each other; they overlap
/// and reach over bounds of 1 to 6 m half extent.
ObstacleField varied_field(std::mt19937_64& random, std::size_t obstacles);

/// One line of JSON for `regista plan`, exact to the last bit.
std::string pasteable(const ObstacleField& field, const PlanRequest& request);

}  // namespace regista::testing
