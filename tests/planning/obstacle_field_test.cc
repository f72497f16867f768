// The fast tests of a whole field against asking every obstacle in turn.
#include "planning/obstacle_field.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "planning/uniform.h"
#include "tests/support/planning_oracles.h"
#include "tests/support/planning_worlds.h"

namespace regista {

TEST_CASE("blockers are exactly the obstacles whose clearance says so") {
  std::mt19937_64 random(5);
  for (int i = 0; i < 2000; ++i) {
    // 200 are boxes in groups, 700 more groups than are looked at in one go.
    const int obstacles = i % 50 == 1 ? 700 : i % 50 == 2 ? 200 : i % 40;
    const ObstacleField field = testing::random_field(random, static_cast<std::size_t>(obstacles));
    const PlanRequest request = testing::random_request(random, field);
    std::vector<ObstacleIndex> expected, expected_covering, found, covering;
    for (ObstacleIndex k = 0; k < field.size(); ++k) {
      if (clearance(request.start, request.goal, field.obstacles()[k]) < -kTouch_m) expected.push_back(k);
      if (clearance(request.start, field.obstacles()[k]) < -kTouch_m) expected_covering.push_back(k);
    }
    field.blockers(request.start, request.goal, found);
    field.covering(request.start, covering);
    std::sort(found.begin(), found.end());
    std::sort(covering.begin(), covering.end());
    CAPTURE(i);
    REQUIRE(found == expected);
    REQUIRE(covering == expected_covering);
    const bool free = testing::segment_is_free(field, request.start, request.goal, request.ignored);
    REQUIRE(field.is_free(request.start, request.goal, request.ignored) == free);
    REQUIRE(field.first_blocker(request.start, request.goal, request.ignored).has_value() == !free);
    REQUIRE(field.is_free(request.goal, request.ignored) ==
            testing::point_is_free(field, request.goal, request.ignored));
  }
}

TEST_CASE("a path is free exactly when all of its legs are") {
  std::mt19937_64 random(8);
  int free_count = 0;
  int blocked_count = 0;
  for (int i = 0; i < 20000; ++i) {
    const ObstacleField field = testing::random_field(random, static_cast<std::size_t>(i % 20 == 0 ? 90 : i % 12));
    const std::vector<std::size_t> ignored =
        field.size() > 0 && i % 3 == 0 ? std::vector<std::size_t>{0} : std::vector<std::size_t>{};
    // Arcs, zigzags, ways back and standing still, in legs of a centimetre to a metre.
    std::vector<Vec2> path{testing::random_point(random, field.bounds())};
    Vec2 along(1.0, 0.0);
    const double bend_rad = uniform(random, -0.5, 0.5);
    const double wild = uniform(random);
    for (std::size_t legs = random() % 30; legs > 0; --legs) {
      along = rotated(along, wild < 0.3 ? uniform(random, -3.0, 3.0) : bend_rad);
      const double length_m = uniform(random) < 0.1 ? 0.0 : wild < 0.6 ? uniform(random, 0.01, 0.15) : uniform(random);
      path.push_back(path.back() + length_m * along);
    }
    if (path.size() == 1) continue;
    bool expected = true;
    for (std::size_t k = 1; k < path.size(); ++k) {
      expected = expected && testing::segment_is_free(field, path[k - 1], path[k], ignored);
    }
    (expected ? free_count : blocked_count) += 1;
    CAPTURE(i);
    REQUIRE(field.is_free(path, ignored) == expected);
  }
  CHECK(free_count > 2000);
  CHECK(blocked_count > 2000);
}

TEST_CASE("the bounds belong to the field") {
  const ObstacleField field({{2.0, 1.0}}, {});
  CHECK(field.is_free({2.0, -1.0}));
  CHECK_FALSE(field.is_free({2.0 + 1e-6, 0.0}));
  CHECK_FALSE(field.is_free({0.0, 0.0}, {0.0, 1.1}));
}

TEST_CASE("an obstacle without size blocks nothing") {
  const ObstacleField field({{2.0, 1.0}}, {disc({0, 0}, 0.0), capsule({-1, -1}, {-1, 1}, 0.0)});
  CHECK(field.is_free({-2.0, 0.0}, {2.0, 0.0}));
}

TEST_CASE("a field that makes no sense is refused with the value") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Bounds bounds{{2.0, 1.0}};
  CHECK_THROWS_WITH(ObstacleField(bounds, {disc({0, 0}, 1), disc({0, 0}, -0.5)}),
                    Catch::Contains("obstacle 1") && Catch::Contains("-0.5"));
  CHECK_THROWS_AS(ObstacleField(bounds, {disc({nan, 0}, 1)}), std::invalid_argument);
  CHECK_THROWS_AS(ObstacleField(bounds, {capsule({0, 0}, {0, nan}, 1)}), std::invalid_argument);
  CHECK_THROWS_AS(ObstacleField({{-1.0, 1.0}}, {}), std::invalid_argument);
  CHECK_THROWS_AS(ObstacleField({{nan, 1.0}}, {}), std::invalid_argument);
}

}  // namespace regista
