// The exact planner against its judge in worlds made by hand: degenerate, symmetric, closed.
#include <catch2/catch.hpp>

#include "tests/planning/tangent_court.h"
#include "tests/support/planning_worlds.h"

namespace regista::testing {

TEST_CASE("in special worlds tangent agrees with the judge") {
  const Bounds wide{{5, 5}};
  const Bounds corridor{{5, 1}};
  Court court;
  const auto check = [&](const Bounds& bounds, const std::vector<Obstacle>& obstacles, const Vec2& start,
                         const Vec2& goal) {
    const ObstacleField field(bounds, obstacles);
    CHECK(court.fault(field, start, goal) == "");
    CHECK(court.fault(field, goal, start) == "");
  };
  const Vec2 left(-3, 0), right(3, 0);
  SECTION("nothing, and nowhere to go") {
    check(wide, {}, left, right);
    check(wide, {disc({0, 0}, 1)}, left, left);
    check(Bounds{{0, 0}}, {}, {0, 0}, {0, 0});
    check(Bounds{{5, 0}}, {}, left, right);
    check(Bounds{{5, 0}}, {disc({0, 0}, 0.1)}, left, right);
  }
  SECTION("symmetric: both ways are equally long") {
    check(wide, {disc({0, 0}, 1)}, left, right);
    check(wide, {rounded_rectangle({-1, -1}, {1, 1}, 0.5), disc({2, 0}, 0.2)}, left, right);
  }
  SECTION("obstacles that touch the bounds") {
    check(corridor, {disc({0, 0}, 1)}, left, right);
    check(corridor, {disc({0, 0}, 1.001)}, left, right);
    check(corridor, {rounded_rectangle({-0.5, -1}, {0.5, 0.75}, 0.25)}, left, right);
    check(corridor, {rounded_rectangle({-0.5, -1}, {0.5, 1}, 0.0)}, left, right);
    check(corridor, {rounded_rectangle({-0.5, -2}, {0.5, 2}, 0.0)}, left, right);
    check(corridor, {disc({0, 0}, 0.5), disc({0, 0.75}, 0.25), disc({0, -0.75}, 0.25)}, left, right);
  }
  SECTION("identical obstacles and obstacles within obstacles") {
    check(wide, {disc({0, 0}, 1), disc({0, 0}, 1), disc({0, 0}, 1)}, left, right);
    check(wide, {disc({0, 0}, 1), disc({0.25, 0}, 0.75), disc({0, 0}, 0.5)}, left, right);
    check(wide, {rounded_rectangle({-1, -1}, {1, 1}, 0), disc({0, 0}, 1), disc({0.5, 0.5}, 0.25)}, left, right);
    check(wide, {capsule({-1, 0}, {1, 0}, 1), rounded_rectangle({-1, 0}, {1, 0}, 1)}, left, right);
    check(wide, {capsule({0, 0}, {0, 0}, 1), rounded_rectangle({0, 0}, {0, 0}, 1)}, left, right);
  }
  SECTION("without radius") {
    check(wide, {capsule({0, -1}, {0, 1}, 0), disc({1, 0}, 0)}, left, right);
    check(wide, {rounded_rectangle({0, -1}, {0, 1}, 0)}, left, right);
    check(wide, {rounded_rectangle({-1, -1}, {1, 1}, 0)}, left, right);
    check(wide, {rounded_rectangle({-1, -1}, {0, 1}, 0), rounded_rectangle({0, -1}, {1, 1}, 0)}, left, right);
    check(wide, {rounded_rectangle({-1, -1}, {1, 1}, 0)}, {-1, -1}, {1, 1});
    check(wide, {rounded_rectangle({-1, -1}, {1, 1}, 0)}, {-1, 0}, {1, 0});
    check(wide, {rounded_rectangle({-1, -1}, {1, 1}, 0)}, {-2, 1}, {2, 1});
  }
  SECTION("along boundaries") {
    check(wide, {disc({0, 0}, 1)}, {-1, 0}, {1, 0});
    check(wide, {disc({0, 0}, 1)}, {0, -1}, {0, 1});
    // Twice half way round and the sides; the short way is closed.
    check(wide, {disc({-1.5, 0}, 0.75), capsule({0, 0}, {1, 0}, 1)}, {0, 1}, {0, -1});
    // The capsule closes a side from corner to corner.
    check(wide, {capsule({-1, 0.5}, {1, 0.5}, 0.5), rounded_rectangle({0, 0}, {3, 1}, 0)}, {0, -1}, {-0.5, 2});
    check(wide, {capsule({-1, 0.5}, {1, 0.5}, 0.5), rounded_rectangle({0, 0}, {3, 1}, 0)}, {0, 0}, {0, 1});
  }
  SECTION("walled in, and out of a hook") {
    check(wide, ring_around({3, 0}, 1.0), left, right);
    check(wide, ring_around({3, 0}, 1.0), {3.1, 0}, {2.9, 0.1});
    check(Bounds{{3, 3}}, {disc({0, 0}, 1), rounded_rectangle({0.5, -0.01}, {4, 0.01}, 0)}, {2, 0.5}, {2, -0.5});
    check(wide, {capsule({-1, -1}, {1, -1}, 0.1), capsule({-1, 1}, {1, 1}, 0.1), capsule({1, -1}, {1, 1}, 0.1)}, {0, 0},
          {3, 0});
  }
}

}  // namespace regista::testing
