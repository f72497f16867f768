// The worlds benches plan in: functions of a random generator alone, the same on every machine.
#pragma once

#include <random>
#include <vector>

#include "planning/obstacle_field.h"
#include "planning/request.h"
#include "world_model/types/field.h"

namespace regista::bench {

struct World {
  Bounds bounds;
  std::vector<Obstacle> obstacles;  ///< robots first where there are any
};

/// A world and what is asked in it.
struct Scene {
  World world;
  PlanRequest request;
};

/// A world and one query per robot of a team.
struct TeamScene {
  World world;
  std::vector<PlanRequest> requests;
};

/// Places in the bounds, no two nearer than `apart_m`, none of them `refused`. Throws std::runtime_error where there is
/// no room.
std::vector<Vec2> places_apart(std::mt19937_64& random, const Bounds& bounds, std::size_t count, double apart_m,
                               const std::function<bool(const Vec2&)>& refused = {});

Vec2 random_point(std::mt19937_64& random, const Bounds& bounds);

/// 11 against 11 on 12 × 9 m (division A): robots anywhere but in each other, keepers alone in their defence areas;
/// both areas, the goals' walls and, half of the time, the capsule to keep clear during ball placement (SSL rules: 0.5
/// m). All robots of yellow ask for the way to a random place; their own disc is none to them, the own area none to the
/// keeper.
TeamScene eleven_against_eleven_team(std::mt19937_64& random);

/// The same, one random robot of yellow asks.
Scene eleven_against_eleven(std::mt19937_64& random);

/// Obstacles of the density of 11 against 11 as one robot sees it: 21 robots on 12 × 9 m.
inline constexpr double kRobotsPerSquareMetre = 21.0 / (12.0 * 9.0);

/// `count` robots among each other on a field of the shape of 12 × 9 m, grown to that density: discs of a robot's
/// radius twice and the margin. The first `asking` of them ask for the way to a random place each.
TeamScene fleet(std::mt19937_64& random, std::size_t count, std::size_t asking);

/// `count` discs of radius 0.21 m anywhere on 12 × 9 m, many of them overlapping; start and goal random.
Scene crowd(std::mt19937_64& random, std::size_t count);

}  // namespace regista::bench
