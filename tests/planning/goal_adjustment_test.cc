// Nearest free points and ways out, against dense sampling.
#include "planning/goal_adjustment.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "planning/uniform.h"
#include "tests/support/planning_oracles.h"
#include "tests/support/planning_worlds.h"

namespace regista {
namespace {

using testing::point_is_free;
using testing::segment_is_free;

/// Random points nearer to `centre` than the claimed distance, dense towards it, of which none may do.
template <class Does>
void require_none_nearer(std::mt19937_64& random, const Vec2& centre, double distance_m, Does&& does) {
  for (int k = 0; k < 1000; ++k) {
    const double radius_m = (distance_m - 1e-7) * std::sqrt(uniform(random));
    const Vec2 point = centre + rotated({radius_m, 0.0}, uniform(random, 0.0, 6.283185307179586));
    if (!does(point)) continue;
    CAPTURE(centre.transpose(), distance_m, point.transpose(), (point - centre).norm());
    FAIL("a nearer point does as well");
  }
}

ObstacleField unbounded(const ObstacleField& field) {
  return {{Vec2::Constant(1e6)}, {field.obstacles().begin(), field.obstacles().end()}};
}

std::vector<std::size_t> with_covering(const ObstacleField& field, const PlanRequest& request) {
  std::vector<std::size_t> all = request.ignored;
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (!is_free(request.start, field.obstacles()[i])) all.push_back(i);
  }
  return all;
}

/// A robot among others at the wall: most touch or cover the start, as shapes do that were shrunk to uncover it.
ObstacleField crowd_around(std::mt19937_64& random, const Vec2& start, std::size_t obstacles) {
  std::vector<Obstacle> all;
  while (all.size() < obstacles) {
    const Vec2 a = start + Vec2(uniform(random, -0.5, 0.5), uniform(random, -0.5, 0.5));
    const Vec2 b = a + Vec2(uniform(random, -0.4, 0.4), uniform(random, -0.4, 0.4));
    Obstacle obstacle = disc(a, uniform(random, 0.1, 0.3));
    const double kind = uniform(random);
    if (kind > 0.8) obstacle = kind > 0.9 ? capsule(a, b, 0.1) : rounded_rectangle(a, b, 0.05);
    const double depth_m = -clearance(start, obstacle);
    if (depth_m > 0.0 && depth_m < obstacle.radius_m && uniform(random) < 0.6) obstacle.radius_m -= depth_m;
    all.push_back(obstacle);
  }
  return {{{1.0, 0.8}}, all};
}

/// Of all places where two outlines or lines that graze one meet, and of all projections, the nearest that does.
template <class Does>
std::optional<double> nearest_by_trying_all(const ObstacleField& field, const Vec2& from, Does&& does) {
  std::vector<Outline> all{outline_of(field.bounds())};
  for (const Obstacle& obstacle : field.obstacles()) {
    all.push_back(outline_of(obstacle));
    append_tangents(from, outline_of(obstacle), 4.0, all);
  }
  std::vector<Vec2> places;
  for (std::size_t i = 0; i < all.size(); ++i) {
    append_projections(from, all[i], places);
    for (std::size_t k = 0; k < i; ++k) append_intersections(all[i], all[k], places);
  }
  std::optional<double> nearest_m;
  for (const Vec2& place : places) {
    const double distance_m = (place - from).norm();
    if ((!nearest_m || distance_m < *nearest_m) && does(place)) nearest_m = distance_m;
  }
  return nearest_m;
}

}  // namespace

TEST_CASE("a free point stays") {
  const ObstacleField field({{5, 5}}, {disc({0, 0}, 1)});
  CHECK(*nearest_free_point(field, {2, 0}) == Vec2(2, 0));
  CHECK(*way_out(field, {1, 0}) == Vec2(1, 0));
  const std::vector<std::size_t> ignored{0};
  CHECK(*nearest_free_point(field, {0, 0}, ignored) == Vec2(0, 0));
}

TEST_CASE("nearest free points of simple worlds") {
  const ObstacleField one({{5, 5}}, {disc({0, 0}, 1)});
  CHECK((*nearest_free_point(one, {0.5, 0}) - Vec2(1, 0)).norm() < 1e-12);
  CHECK(nearest_free_point(one, {0, 0})->norm() == Approx(1));
  // Between two overlapping discs the nearest free point is where their boundaries meet.
  const ObstacleField two({{5, 5}}, {disc({-0.6, 0}, 1), disc({0.6, 0}, 1)});
  CHECK((*nearest_free_point(two, {0, 0.1}) - Vec2(0, 0.8)).norm() < 1e-12);
  // In the corner of the field, on the bounds.
  const ObstacleField corner({{5, 5}}, {rounded_rectangle({4, 3}, {6, 6}, 0.5)});
  CHECK((*nearest_free_point(corner, {4.9, 2.6}) - Vec2(4.9, 2.5)).norm() < 1e-12);
  CHECK((*nearest_free_point(one, {7, 1}) - Vec2(5, 1)).norm() < 1e-12);
}

TEST_CASE("nothing is free in a covered field") {
  const ObstacleField field({{5, 5}}, {disc({0, 0}, 20)});
  CHECK_FALSE(nearest_free_point(field, {1, 1}));
  CHECK_FALSE(way_out(field, {1, 1}));
}

TEST_CASE("the way out crosses nothing that does not cover the start") {
  // The small disc covers the start; the nearest free point is to the right, but a wall stands there.
  const ObstacleField field({{5, 5}}, {disc({0, 0}, 1), rounded_rectangle({0.5, -2}, {0.8, 2}, 0)});
  const Vec2 start(0.4, 0);
  const Vec2 out = *way_out(field, start);
  CHECK(field.is_free(out));
  CHECK(is_free(start, out, field.obstacles()[1]));
  // To the left would be 1.4 m; upwards, along the wall to where it meets the disc, is shorter.
  CHECK((out - start).norm() == Approx(std::hypot(0.1, std::sqrt(0.75))));
}

TEST_CASE("the way out may graze an obstacle in its way") {
  // A bar just right of the start: the shortest allowed leg passes its end.
  const ObstacleField field({{9, 9}}, {disc({0, 0}, 2), capsule({0.6, -0.3}, {0.6, 0.3}, 0.1)});
  const Vec2 start(0.4, 0);
  const Vec2 out = *way_out(field, start);
  CHECK(field.is_free(out));
  CHECK(is_free(start, out, field.obstacles()[1]));
  CHECK((out - start).norm() < 1.9);
}

TEST_CASE("the way out may graze an obstacle that lies all within what covers the start") {
  // The disc touches the start from below and a little to the right: straight to the right, the nearest side, it is in
  // the way by a hair.
  const Vec2 start(0.9, 0);
  const Vec2 downwards = Vec2(0.1, -1).normalized();
  const ObstacleField field({{9, 9}}, {rounded_rectangle({-1, -1}, {1, 1}, 0.1), disc(start + 0.05 * downwards, 0.05)});
  const Vec2 out = *way_out(field, start);
  CHECK(is_free(start, out, field.obstacles()[1]));
  CHECK((out - Vec2(1.1, 0.02)).norm() < 1e-7);
}

TEST_CASE("no free sample is nearer than the nearest free point") {
  std::mt19937_64 random(6);
  int moved = 0;
  for (int i = 0; i < 1500; ++i) {
    const ObstacleField field = testing::random_field(random, static_cast<std::size_t>(20 + i % 100));
    PlanRequest request = testing::random_request(random, field);
    if (i % 10 == 0) request.goal *= 1.3;  // some outside the bounds
    const std::optional<Vec2> found = nearest_free_point(field, request.goal, request.ignored);
    CAPTURE(i);
    REQUIRE(found);
    REQUIRE(point_is_free(field, *found, request.ignored));
    const double distance_m = (*found - request.goal).norm();
    if (distance_m == 0.0) continue;
    ++moved;
    require_none_nearer(random, request.goal, distance_m,
                        [&](const Vec2& point) { return point_is_free(field, point, request.ignored); });
  }
  CHECK(moved > 300);
}

TEST_CASE("no sampled way out is shorter than the way out") {
  std::mt19937_64 random(7);
  int moved = 0;
  for (int i = 0; i < 1500; ++i) {
    const ObstacleField field = testing::random_field(random, static_cast<std::size_t>(20 + i % 100));
    PlanRequest request = testing::random_request(random, field);
    if (i % 10 == 0) request.start *= 1.3;
    if (point_is_free(field, request.start, request.ignored)) continue;
    const std::vector<std::size_t> crossed = with_covering(field, request);
    const ObstacleField no_bounds = unbounded(field);
    const auto leads_out = [&](const Vec2& point) {
      return point_is_free(field, point, request.ignored) && segment_is_free(no_bounds, request.start, point, crossed);
    };
    const std::optional<Vec2> found = way_out(field, request.start, request.ignored);
    CAPTURE(i, request.start.transpose());
    ++moved;
    if (found) REQUIRE(leads_out(*found));
    const double distance_m = found ? (*found - request.start).norm() : 3.0;
    require_none_nearer(random, request.start, distance_m, leads_out);
  }
  CHECK(moved > 300);
}

TEST_CASE("in a crowd the way out is the nearest of all places there are, or there is none") {
  std::mt19937_64 random(8);
  int found_some = 0;
  int found_none = 0;
  for (int i = 0; i < 6000; ++i) {
    PlanRequest request;
    request.start = {uniform(random, -0.9, 0.9), i % 2 == 0 ? 0.8 + uniform(random, 0.0, 0.01) : 0.7};
    const ObstacleField field = crowd_around(random, request.start, static_cast<std::size_t>(4 + i % 10));
    if (i % 5 == 0) request.ignored = {0, 2};
    if (point_is_free(field, request.start, request.ignored)) continue;
    const std::vector<std::size_t> crossed = with_covering(field, request);
    const ObstacleField no_bounds = unbounded(field);
    const std::optional<double> nearest_m = nearest_by_trying_all(field, request.start, [&](const Vec2& point) {
      return point_is_free(field, point, request.ignored) && segment_is_free(no_bounds, request.start, point, crossed);
    });
    const std::optional<Vec2> found = way_out(field, request.start, request.ignored);
    CAPTURE(i, request.start.transpose());
    REQUIRE(found.has_value() == nearest_m.has_value());
    if (found) CHECK((*found - request.start).norm() == Approx(*nearest_m).margin(1e-9));
    ++(found ? found_some : found_none);
  }
  CHECK(found_some > 300);
  CHECK(found_none > 200);
}

TEST_CASE("in a crowd the nearest free point is the nearest of all places there are") {
  std::mt19937_64 random(9);
  for (int i = 0; i < 500; ++i) {
    const Vec2 goal(uniform(random, -1.1, 1.1), uniform(random, -0.9, 0.9));
    const ObstacleField field = crowd_around(random, goal, static_cast<std::size_t>(4 + i % 30));
    const std::optional<double> nearest_m =
        nearest_by_trying_all(field, goal, [&](const Vec2& point) { return point_is_free(field, point, {}); });
    const std::optional<Vec2> found = nearest_free_point(field, goal);
    CAPTURE(i, goal.transpose());
    if (found == goal) continue;
    REQUIRE(found.has_value() == nearest_m.has_value());
    if (found) CHECK((*found - goal).norm() == Approx(*nearest_m).margin(1e-9));
  }
}

}  // namespace regista
