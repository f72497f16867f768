// The exact planner against its judge where things touch exactly: starts and goals on boundaries, obstacles on a grid,
// gates of no width.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "planning/uniform.h"
#include "tests/planning/tangent_court.h"
#include "tests/support/planning_worlds.h"
#include "tests/support/share.h"
#include "tests/support/varied_worlds.h"

namespace regista::testing {
namespace {

/// A point on the obstacle's boundary, up to rounding, or within the obstacle.
Vec2 on_boundary(std::mt19937_64& random, const Obstacle& obstacle) {
  const Vec2 corner = uniform(random) < 0.5 ? obstacle.a : obstacle.b;
  const int quarters = static_cast<int>(random() % 4);
  const double angle = uniform(random) < 0.5 ? quarters * std::numbers::pi / 2 : uniform(random, -3.0, 3.0);
  return corner + rotated({obstacle.radius_m, 0.0}, angle);
}

/// Discs, rectangles without radius and capsules on a grid, so that they touch
/// exactly, share sides and corners, and stand in line.
ObstacleField grid_field(std::mt19937_64& random) {
  std::vector<Obstacle> all;
  const double filled = uniform(random, 0.1, 0.6);
  for (int x = -3; x < 3; ++x) {
    for (int y = -2; y < 2; ++y) {
      if (uniform(random) > filled) continue;
      const Vec2 low(x, y), middle(x + 0.5, y + 0.5);
      const double kind = uniform(random);
      if (kind < 0.4) all.push_back(disc(middle, kind < 0.1 ? 0.5625 : 0.5));
      if (kind >= 0.4 && kind < 0.7) all.push_back(rounded_rectangle(low, low + Vec2(1, 1), 0.0));
      if (kind >= 0.7 && kind < 0.8) all.push_back(rounded_rectangle(low + Vec2(.25, .25), low + Vec2(.75, .75), 0.25));
      if (kind >= 0.8 && kind < 0.9) all.push_back(capsule(middle, middle + Vec2(1, 0), 0.5));
      if (kind >= 0.9) all.push_back(capsule(middle, middle + Vec2(0, 1), 0.25));
    }
  }
  return {Bounds{{3, 2}}, all};
}

Vec2 grid_point(std::mt19937_64& random) {
  const auto step = [&](int half) {
    return 0.5 * (static_cast<double>(random() % static_cast<unsigned>(4 * half + 1)));
  };
  const double x = step(3);
  return {x - 3.0, step(2) - 2.0};
}

/// A row of discs from bound to bound, each touching the next: the only ways
/// through have no width.
ObstacleField touching_row(std::mt19937_64& random) {
  std::vector<Obstacle> all;
  double y = -2.0;
  double x = 0.0;
  double radius = 0.0;
  while (y < 2.0) {
    const double next = uniform(random, 0.2, 0.8);
    const double lean = uniform(random, -0.5, 0.5);
    if (!all.empty()) {
      x += (radius + next) * std::sin(lean);
      y += (radius + next) * std::cos(lean);
    }
    all.push_back(disc({x, y}, next));
    radius = next;
  }
  return {Bounds{{5, 2}}, all};
}

}  // namespace

TEST_CASE("with start and goal on boundaries tangent agrees with the judge") {
  Court court;
  for (int world = 0; world < share_of(10000); ++world) {
    std::mt19937_64 random = generator(world);
    const ObstacleField field = varied_field(random, 1 + random() % 6);
    PlanRequest request = random_free_request(random, field);
    request.start = on_boundary(random, field.obstacles()[random() % field.size()]);
    if (world % 3 != 0) request.goal = on_boundary(random, field.obstacles()[random() % field.size()]);
    CAPTURE(world);
    REQUIRE(court.fault(field, request) == "");
  }
  CHECK(court.worlds() > share_of(4000));
  CHECK(court.bent() > share_of(2500));
}

TEST_CASE("on a grid of obstacles that touch exactly tangent agrees with the judge") {
  Court court;
  for (int world = 0; world < share_of(10000); ++world) {
    std::mt19937_64 random = generator(world);
    const ObstacleField field = grid_field(random);
    const Vec2 start = grid_point(random);
    CAPTURE(world);
    REQUIRE(court.fault(field, start, grid_point(random)) == "");
  }
  CHECK(court.worlds() > share_of(7000));
  CHECK(court.bent() > share_of(4000));
}

TEST_CASE("through gates of no width tangent agrees with the judge") {
  Court court;
  for (int world = 0; world < share_of(1000); ++world) {
    std::mt19937_64 random = generator(world);
    const ObstacleField field = touching_row(random);
    const Vec2 start(-4.5, uniform(random, -2.0, 2.0));
    CAPTURE(world);
    REQUIRE(court.fault(field, start, {4.5, uniform(random, -2.0, 2.0)}) == "");
  }
  CHECK(court.bent() > share_of(900));
}

}  // namespace regista::testing
