// The exact clearance against dense sampling and against the symmetries of the plane.
#include "planning/clearance.h"

#include <array>
#include <catch2/catch.hpp>

#include "planning/obstacle_field.h"
#include "planning/uniform.h"
#include "tests/support/planning_oracles.h"
#include "tests/support/planning_worlds.h"

namespace regista {
namespace {

using testing::random_obstacle;
using testing::random_point;

constexpr double kStep_m = 2e-3;

Obstacle moved(const Obstacle& obstacle, const Vec2& by) {
  return {obstacle.core, obstacle.a + by, obstacle.b + by, obstacle.radius_m};
}

}  // namespace

TEST_CASE("a segment is free where its clearance says so") {
  std::mt19937_64 random(6);
  const auto coarse = [&random] { return 0.25 * (static_cast<double>(random() % 9) - 4.0); };
  for (int i = 0; i < 100000; ++i) {
    // On a coarse grid, so that shapes degenerate, touch and lie in line.
    const bool is_coarse = i % 2 == 0;
    const auto point = [&] { return is_coarse ? Vec2(coarse(), coarse()) : random_point(random, Bounds{{3, 2}}); };
    const Vec2 a = point();
    const Vec2 b = point();
    constexpr std::array kRadii{0.0, kTouch_m, 0.25, 0.5, 1.0};
    const double radius_m = is_coarse ? kRadii[random() % kRadii.size()] : uniform(random);
    const Obstacle obstacle = i % 3 == 0   ? disc(a, radius_m)
                              : i % 3 == 1 ? capsule(a, b, radius_m)
                                           : rounded_rectangle(a, b, radius_m);
    const Vec2 from = point();
    const Vec2 to = i % 7 == 0 ? from : point();
    const double clearance_m = clearance(from, to, obstacle);
    constexpr double kRounding_m = 1e-12;
    if (std::abs(clearance_m + kTouch_m) < kRounding_m) continue;
    CAPTURE(i);
    REQUIRE(is_free(from, to, obstacle) == (clearance_m >= -kTouch_m));
  }
}

TEST_CASE("clearance of simple shapes") {
  CHECK(clearance(Vec2(3, 4), disc({0, 0}, 1)) == Approx(4));
  CHECK(clearance(Vec2(0, 0), disc({0, 0}, 1)) == Approx(-1));
  CHECK(clearance(Vec2(1, 2), capsule({0, 0}, {4, 0}, 0.5)) == Approx(1.5));
  CHECK(clearance(Vec2(7, 4), capsule({0, 0}, {4, 0}, 0.5)) == Approx(4.5));
  const Obstacle area = rounded_rectangle({6, 2}, {4, -2}, 0.1);
  CHECK(clearance(Vec2(3, 0), area) == Approx(0.9));
  CHECK(clearance(Vec2(1, -6), area) == Approx(4.9));
  CHECK(clearance(Vec2(5.5, 0), area) == Approx(-0.6));
}

TEST_CASE("clearance of a segment through, beside and within") {
  CHECK(clearance({-5, 0}, {5, 0}, disc({0, 0.5}, 1)) == Approx(-0.5));
  CHECK(clearance({-5, -1}, {5, 1}, capsule({0, -3}, {0, 3}, 0.25)) == Approx(-0.25));
  const Obstacle area = rounded_rectangle({-2, -1}, {2, 1}, 0.5);
  CHECK(clearance({-9, 0}, {9, 0}, area) == Approx(-1.5));
  CHECK(clearance({-9, 1.25}, {9, 1.25}, area) == Approx(-0.25));
  CHECK(clearance({-1, 0.2}, {1, 0.2}, area) == Approx(-1.3));
  // Past a corner at 45°: the nearest place is the projection of the corner.
  CHECK(clearance({2, 3}, {4, 1}, area) == Approx(std::sqrt(2.0) - 0.5));
}

TEST_CASE("touching is free, a nanometre more is not") {
  const Obstacle robot = disc({0, 0.2}, 0.2);
  CHECK(is_free({-1, 0}, {1, 0}, robot));
  CHECK_FALSE(is_free({-1, 3e-9}, {1, 3e-9}, robot));
}

TEST_CASE("without radius a rectangle blocks its interior, disc and capsule block nothing") {
  for (const Obstacle& thin : {disc({0, 0}, 0), capsule({0, -1}, {0, 1}, 0), rounded_rectangle({0, -1}, {0, 1}, 0)}) {
    CHECK(is_free({0, 0}, thin));
    CHECK(is_free({-1, 0}, {1, 0}, thin));
    CHECK(is_free({0, -2}, {0, 2}, thin));
    CHECK(ObstacleField({{3, 3}}, {thin}).is_free({-1, 0}, {1, 0}));
  }
  const Obstacle box = rounded_rectangle({-1, -1}, {1, 1}, 0);
  CHECK_FALSE(is_free({0, 0}, box));
  CHECK_FALSE(is_free({-2, 0.999}, {2, 0.999}, box));
  CHECK_FALSE(ObstacleField({{3, 3}}, {box}).is_free({-2, 0.999}, {2, 0.999}));
  CHECK(is_free({-2, 1}, {2, 1}, box));
  CHECK(is_free({1, 0}, box));
}

TEST_CASE("clearance of a point agrees with the nearest boundary point") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 300; ++i) {
    const Obstacle obstacle = random_obstacle(random, testing::test_bounds());
    const Vec2 point = i % 2 == 0 ? random_point(random, testing::test_bounds())
                                  : Vec2(obstacle.a + random_point(random, {{1.0, 1.0}}));
    CAPTURE(i, point.transpose(), static_cast<int>(obstacle.core), obstacle.radius_m);
    const double exact = clearance(point, obstacle);
    const double sampled = testing::sampled_clearance(point, obstacle, kStep_m);
    REQUIRE(std::abs(exact) <= std::abs(sampled) + 1e-12);
    REQUIRE(std::abs(exact) >= std::abs(sampled) - kStep_m);
    if (std::abs(exact) > kStep_m) REQUIRE((exact < 0) == (sampled < 0));
  }
}

TEST_CASE("clearance of a segment is the least of its points'") {
  std::mt19937_64 random(2);
  for (int i = 0; i < 3000; ++i) {
    const Obstacle obstacle = random_obstacle(random, testing::test_bounds());
    const Vec2 from = random_point(random, testing::test_bounds());
    // Some exactly along an axis, where denominators vanish.
    Vec2 to = random_point(random, testing::test_bounds());
    if (i % 7 == 0) to.x() = from.x();
    if (i % 11 == 0) to.y() = from.y();
    CAPTURE(i, from.transpose(), to.transpose(), static_cast<int>(obstacle.core));
    constexpr int kSteps = 1000;
    double least = clearance(from, obstacle);
    for (int k = 1; k <= kSteps; ++k) {
      least = std::min(least, clearance(Vec2(from + (to - from) * k / kSteps), obstacle));
    }
    const double exact = clearance(from, to, obstacle);
    REQUIRE(exact <= least + 1e-12);
    REQUIRE(exact >= least - (to - from).norm() / kSteps);
    // The distance is 1-Lipschitz and convex, so around the best sample hardly anything can hide.
    REQUIRE(clearance(to, from, obstacle) == Approx(exact).margin(1e-12));
  }
}

TEST_CASE("clearance is invariant under translation and mirror") {
  std::mt19937_64 random(3);
  for (int i = 0; i < 2000; ++i) {
    const Obstacle obstacle = random_obstacle(random, testing::test_bounds());
    const Vec2 from = random_point(random, testing::test_bounds());
    const Vec2 to = random_point(random, testing::test_bounds());
    const Vec2 by = random_point(random, testing::test_bounds());
    const double exact = clearance(from, to, obstacle);
    CAPTURE(i);
    REQUIRE(clearance(Vec2(from + by), Vec2(to + by), moved(obstacle, by)) == Approx(exact).margin(1e-12));
    for (const Vec2& signs : {Vec2(-1, 1), Vec2(1, -1)}) {
      REQUIRE(clearance(Vec2(from.cwiseProduct(signs)), Vec2(to.cwiseProduct(signs)),
                        testing::mirrored(obstacle, signs)) == Approx(exact).margin(1e-12));
    }
    if (obstacle.core == Core::rectangle) continue;
    const double turn_rad = uniform(random, -3.0, 3.0);
    const Obstacle turned{obstacle.core, rotated(obstacle.a, turn_rad), rotated(obstacle.b, turn_rad),
                          obstacle.radius_m};
    REQUIRE(clearance(rotated(from, turn_rad), rotated(to, turn_rad), turned) == Approx(exact).margin(1e-12));
  }
}

TEST_CASE("clearance is symmetric between a segment and a capsule's core") {
  std::mt19937_64 random(4);
  for (int i = 0; i < 1000; ++i) {
    Vec2 p[4];
    for (Vec2& point : p) point = random_point(random, testing::test_bounds());
    REQUIRE(clearance(p[0], p[1], capsule(p[2], p[3], 0.0)) ==
            Approx(clearance(p[2], p[3], capsule(p[0], p[1], 0.0))).margin(1e-12));
  }
}

}  // namespace regista
