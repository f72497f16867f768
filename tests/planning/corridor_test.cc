#include "planning/graph/corridor.h"

#include <catch2/catch.hpp>
#include <random>

#include "planning/uniform.h"

namespace regista::graph {
namespace {

std::vector<Obstacle> random_obstacles(std::mt19937_64& random, std::size_t count, double half_m) {
  const auto place = [&] { return Vec2(uniform(random, -half_m, half_m), uniform(random, -half_m, half_m)); };
  std::vector<Obstacle> obstacles;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 a = place();
    const Vec2 b = a + 0.05 * place();
    const double radius_m = uniform(random, 0.0, 0.5);
    obstacles.push_back(i % 3 == 0   ? disc(a, radius_m)
                        : i % 3 == 1 ? capsule(a, b, radius_m)
                                     : rounded_rectangle(a, b, radius_m));
  }
  return obstacles;
}

std::vector<ObstacleIndex> blockers(const Corridor& corridor, const ObstacleField& field, const Vec2& from,
                                    const Vec2& to) {
  std::vector<ObstacleIndex> found;
  const Vec2 along = (to - from).normalized();
  corridor.visit_candidates(field, {from, to, along}, [&](ObstacleIndex i) {
    if (!is_free(from, to, field.obstacles()[i])) found.push_back(i);
    return false;
  });
  return found;
}

}  // namespace

TEST_CASE("within a corridor, across its border and before it is laid out a leg has the field's blockers, in order") {
  std::mt19937_64 random(11);
  constexpr double kHalf_m = 15.0;
  Corridor corridor;
  for (int world = 0; world < 200; ++world) {
    CAPTURE(world);
    const ObstacleField field({Vec2(kHalf_m, kHalf_m)}, random_obstacles(random, world % 2 == 0 ? 300 : 30, kHalf_m));
    const auto place = [&](double half_m) {
      return Vec2(uniform(random, -half_m, half_m), uniform(random, -half_m, half_m));
    };
    const Vec2 start = place(kHalf_m);
    const Vec2 goal = world % 10 == 0 ? start : place(kHalf_m);
    corridor.clear();
    if (world % 7 != 0) corridor.lay_out(field, start, goal, uniform(random, 0.0, 2.0));
    for (int leg = 0; leg < 50; ++leg) {
      const Vec2 from = start + uniform(random) * (goal - start) + place(1.5);
      const Vec2 to = start + uniform(random) * (goal - start) + place(1.5);
      std::vector<ObstacleIndex> expected;
      field.blockers(from, to, expected);
      CHECK(blockers(corridor, field, from, to) == expected);
    }
  }
}

}  // namespace regista::graph
