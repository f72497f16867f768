// The fast tests of a whole field against asking every obstacle in turn.
#include "planning/obstacle_field.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/planning_oracles.h"
#include "tests/support/planning_worlds.h"

namespace regista {

TEST_CASE("blockers are exactly the obstacles whose clearance says so") {
  std::mt19937_64 random(5);
  for (int i = 0; i < 2000; ++i) {
    const ObstacleField field = testing::random_field(random, static_cast<std::size_t>(i % 40));
    const PlanRequest request = testing::random_request(random, field);
    std::vector<ObstacleIndex> expected, expected_covering, found, covering;
    for (ObstacleIndex k = 0; k < field.size(); ++k) {
      if (!is_free(request.start, request.goal, field.obstacles()[k])) expected.push_back(k);
      if (!is_free(request.start, field.obstacles()[k])) expected_covering.push_back(k);
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
