// Random worlds for planning's tests: seeded, the same on every machine.
#pragma once

#include <random>

#include "planning/obstacle_field.h"
#include "planning/request.h"

namespace regista::testing {

/// 12 × 9 m, as a robot's centre may use it.
inline constexpr double kHalfLength_m = 6.2;
inline constexpr double kHalfWidth_m = 4.5;
Bounds test_bounds();

Vec2 random_point(std::mt19937_64& random, const Bounds& bounds);

/// Mostly discs of robots' size, some capsules and rounded rectangles; they may overlap and reach over the bounds.
Obstacle random_obstacle(std::mt19937_64& random, const Bounds& bounds);
ObstacleField random_field(std::mt19937_64& random, std::size_t obstacles);

/// Start and goal anywhere within the bounds, free or not; ignores obstacles now and then.
PlanRequest random_request(std::mt19937_64& random, const ObstacleField& field);
/// The same with start and goal free; gives up and returns the last try in a crowded field.
PlanRequest random_free_request(std::mt19937_64& random, const ObstacleField& field);

/// signs: (-1, 1) mirrors x, (1, -1) mirrors y.
Obstacle mirrored(const Obstacle& obstacle, const Vec2& signs);
ObstacleField mirrored(const ObstacleField& field, const Vec2& signs);
PlanRequest mirrored(PlanRequest request, const Vec2& signs);

/// A closed square ring of overlapping discs around `centre`.
std::vector<Obstacle> ring_around(const Vec2& centre, double radius_m);

}  // namespace regista::testing
