// DVG's geometry: octagons, polygons around obstacles, the active region, and what may be done to its objects.
#include <catch2/catch.hpp>

#include "planning/planners/dvg_published.h"
#include "planning/planners/dvg_region.h"
#include "tests/planning/octagon.h"
#include "tests/support/planning_worlds.h"

namespace regista {
namespace {

using dvg::Object;
using testing::depth;
using testing::direction;

constexpr double kRobot = dvg::kRobotObject_m;

}  // namespace

TEST_CASE("a segment crosses an octagon where one of its points is inside") {
  std::mt19937_64 random(7);
  const Bounds around{{0.5, 0.5}};
  int crossings = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec2 from = testing::random_point(random, around);
    const Vec2 to = testing::random_point(random, around);
    double deepest_m = -1.0;
    for (int k = 0; k <= 1000; ++k) {
      deepest_m = std::max(deepest_m, depth(from + (to - from) * (k / 1000.0), {0.1, 0}, kRobot));
    }
    if (std::abs(deepest_m) < 1e-3) continue;
    INFO("case " << i);
    REQUIRE(dvg::crosses_octagon(from, to, {0.1, 0}, kRobot) == (deepest_m > 0.0));
    crossings += deepest_m > 0.0 ? 1 : 0;
  }
  CHECK(crossings > 500);
  const dvg::Polygon octagon = dvg::octagon({1, 2}, kRobot);
  REQUIRE(octagon.count == 8);
  for (std::size_t k = 0; k < 8; ++k) {
    CHECK((octagon.store[k] - Vec2(1, 2)).norm() == Approx(kRobot));
    CHECK_FALSE(dvg::crosses_octagon(octagon.store[k], octagon.store[(k + 1) % 8], {1, 2}, kRobot));
    CHECK(dvg::crosses_octagon(octagon.store[k], octagon.store[(k + 2) % 8], {1, 2}, kRobot));
  }
}

TEST_CASE("the polygon around an obstacle holds it and has free corners") {
  std::mt19937_64 random(8);
  for (int i = 0; i < 500; ++i) {
    const Obstacle obstacle = testing::random_obstacle(random, testing::test_bounds());
    const dvg::Polygon polygon = dvg::polygon_around(obstacle);
    INFO("obstacle " << i);
    CHECK(polygon.is_disc == (obstacle.core == Core::point));
    for (const Vec2& corner : polygon.vertices()) CHECK(is_free(corner, obstacle));
    for (int k = 0; k < 360; ++k) {
      const Vec2 outwards = direction(k, 360);
      double reach_m = -1e9;
      for (const Vec2& corner : polygon.vertices()) reach_m = std::max(reach_m, outwards.dot(corner));
      double needed_m = -1e9;
      for (const double x : {obstacle.a.x(), obstacle.b.x()}) {
        for (const double y : {obstacle.a.y(), obstacle.b.y()}) {
          const bool is_of_core =
              obstacle.core != Core::segment || Vec2(x, y) == obstacle.a || Vec2(x, y) == obstacle.b;
          if (is_of_core) needed_m = std::max(needed_m, outwards.dot(Vec2(x, y)) + obstacle.radius_m);
        }
      }
      REQUIRE(reach_m >= needed_m);
      REQUIRE(reach_m <= needed_m + 0.42 * obstacle.radius_m + 1e-6);
    }
  }
}

TEST_CASE("the active region is a strip along the line, of its length") {
  const dvg::ActiveRegion region({0, 0}, {4, 0}, 1.0);
  const auto reaches = [&](const Vec2& centre) { return region.is_reached_by(dvg::octagon(centre, 0.24).vertices()); };
  CHECK(reaches({2, 0}));
  CHECK(reaches({2, 1.23}));
  CHECK(reaches({2, -1.23}));
  CHECK_FALSE(reaches({2, 1.25}));
  CHECK(reaches({-0.23, 0}));
  CHECK_FALSE(reaches({-0.25, 0}));
  CHECK_FALSE(reaches({4.25, 0}));
  const dvg::ActiveRegion longer({0, 0}, {4, 0}, 2.0, 1.0);
  CHECK(longer.is_reached_by(dvg::octagon({-1.2, 2.2}, 0.24).vertices()));
}

TEST_CASE("objects near each other become one that holds them all") {
  const std::vector<Object> all{{{0, 0}, 0.24}, {{3, 3}, 0.3}, {{0.4, 0}, 0.24}, {{0.8, 0}, 0.24}};
  std::vector<Object> objects = all;
  dvg::group_near(objects, {-3, 0}, {3, 0}, 0.5);
  REQUIRE(objects.size() == 2);
  CHECK((objects[0].centre - Vec2(0.4, 0)).norm() < 1e-12);
  CHECK(objects[0].radius_m == Approx(0.64));
  CHECK(objects[0].is_enlarged);
  CHECK(objects[1] == all[1]);
  for (const Vec2& held : {Vec2(0.4, 0.6), Vec2(-0.2, 0)}) {
    objects = all;
    dvg::group_near(objects, held, {3, 0}, 0.5);
    CHECK(objects.size() == 4);
    objects = all;
    dvg::group_near(objects, {-3, 0}, held, 0.5);
    CHECK(objects.size() == 4);
  }
  objects = all;
  dvg::group_near(objects, {-3, 0}, {3, 0}, 0.4);
  CHECK(objects == all);
}

TEST_CASE("objects grow with their distance from the goal, but not over start or goal") {
  DvgParams params;
  params.unchanged_within_m = 1.0;
  params.growth = 0.05;
  params.radius_max_m = 0.4;
  std::vector<Object> objects{{{0.9, 0}, 0.24}, {{3, 0}, 0.24}, {{8, 0}, 0.24}, {{9.7, 0}, 0.24}, {{10.1, 0}, 0.24}};
  dvg::grow_far(objects, {10, 0}, {0, 0}, params);
  CHECK(objects[0] == Object{{0.9, 0}, 0.24, false});
  CHECK(objects[1].radius_m == Approx(0.34));
  CHECK(objects[1].is_enlarged);
  CHECK(objects[2].radius_m == Approx(0.4));
  CHECK(objects[3].radius_m == Approx(0.3));
  CHECK(objects[4] == Object{{10.1, 0}, 0.24, false});
}

}  // namespace regista
