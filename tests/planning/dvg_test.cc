// DVG+A*: its geometry, what may be done to its objects, the published search and the one for a robot that drives.
#include "planning/planners/dvg.h"

#include <catch2/catch.hpp>

#include "planning/planners/dvg_published.h"
#include "planning/planners/dvg_region.h"
#include "planning/registry.h"
#include "tests/support/planning_worlds.h"

namespace regista {
namespace {

using dvg::Object;

constexpr double kRobot = dvg::kRobotObject_m;

PlanRequest request_of(const Vec2& start, const Vec2& goal) {
  PlanRequest request;
  request.start = start;
  request.goal = goal;
  return request;
}

dvg::Result find(const std::vector<Object>& objects, const Vec2& start, const Vec2& goal, const DvgParams& params = {},
                 const Budget& budget = {}) {
  dvg::Graph graph;
  dvg::Result result;
  dvg::find(objects, start, goal, params, graph, result, budget);
  return result;
}

DvgParams without_limit() {
  DvgParams params;
  params.edge_limit = false;
  return params;
}

Vec2 direction(int k, int of) {
  const double angle_rad = 2.0 * std::numbers::pi * k / of;
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

/// How deep the point lies within the octagon, metres; by its definition as a hull, not by its normals.
double depth(const Vec2& point, const Vec2& centre, double radius_m) {
  double least = radius_m;
  for (int k = 0; k < 8; ++k) {
    const Vec2 a = centre + radius_m * direction(k, 8);
    const Vec2 b = centre + radius_m * direction(k + 1, 8);
    least = std::min(least, cross((b - a).normalized(), point - a));
  }
  return least;
}

/// A way through six random robots, and its length by relaxing all edges over and over.
double shortest_m(const std::vector<Object>& objects, const Vec2& start, const Vec2& goal) {
  std::vector<Vec2> nodes{start, goal};
  const auto is_blocked = [&](const Vec2& from, const Vec2& to) {
    return std::any_of(objects.begin(), objects.end(), [&](const Object& object) {
      for (int i = 0; i <= 1000; ++i) {
        if (depth(from + (to - from) * (i / 1000.0), object.centre, object.radius_m) > 1e-6) return true;
      }
      return false;
    });
  };
  for (const Object& object : objects) {
    for (int k = 0; k < 8; ++k) {
      const Vec2 corner = object.centre + object.radius_m * direction(k, 8);
      if (!is_blocked(corner, corner)) nodes.push_back(corner);
    }
  }
  const std::size_t count = nodes.size();
  std::vector<double> edge_m(count * count, 1e9);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const bool blocked = is_blocked(nodes[i], nodes[j]);
      if (!blocked) edge_m[i * count + j] = edge_m[j * count + i] = (nodes[i] - nodes[j]).norm();
    }
  }
  std::vector<double> cost(count, 1e9);
  cost[0] = 0.0;
  for (std::size_t round = 0; round < count; ++round) {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) cost[j] = std::min(cost[j], cost[i] + edge_m[i * count + j]);
    }
  }
  return cost[1];
}

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

TEST_CASE("published: one robot in the way") {
  const dvg::Result result = find({{{0, 0}, kRobot}}, {-2, 0.01}, {2, 0.01});
  CHECK(result.end == dvg::End::goal);
  CHECK(result.objects == 1);
  CHECK(result.nodes == 10);
  // The eight sides, and five corners in sight of either end.
  CHECK(result.edges == 8 + 5 + 5);
  REQUIRE(result.path.size() == 3);
  CHECK((result.path[1] - Vec2(0, kRobot)).norm() < 1e-12);
  DvgParams everywhere;
  everywhere.exception_everywhere = true;
  const dvg::Result cutting = find({{{0, 0}, kRobot}}, {-2, 0.01}, {2, 0.01}, everywhere);
  // To the goal all corners but the one farthest from it.
  CHECK(cutting.edges == 8 + 5 + 7);
  CHECK(length_of(cutting.path) < length_of(result.path));
}

TEST_CASE("published: only the active region counts") {
  const std::vector<Object> beside{{{0, 1.3}, kRobot}, {{-2.3, 0}, kRobot}, {{2.3, 0}, kRobot}};
  const dvg::Result result = find(beside, {-2, 0}, {2, 0});
  CHECK(result.objects == 0);
  CHECK(result.path == std::vector<Vec2>{{-2, 0}, {2, 0}});
}

TEST_CASE("published: an edge to the goal may enter an object, as far as the robot's radius from its centre") {
  const std::vector<Object> robot{{{0, 0}, kRobot}};
  const dvg::Result beside = find(robot, {-2, 0}, {0, 0.12});
  CHECK(beside.end == dvg::End::goal);
  CHECK(beside.path == std::vector<Vec2>{{-2, 0}, {0, 0.12}});
  const dvg::Result behind = find(robot, {-2, 0}, {0.12, 0});
  CHECK(behind.end == dvg::End::goal);
  CHECK(behind.path.size() > 2);
  const dvg::Result on_top = find(robot, {-2, 0}, {0, 0.08});
  CHECK(on_top.end == dvg::End::no_way);
  CHECK(on_top.path.front() == Vec2(-2, 0));
  CHECK((on_top.path.back() - Vec2(0, 0.08)).norm() < 0.24);
  // And the other way round: out of an object.
  CHECK(find(robot, {0.12, 0}, {-2, 0}).end == dvg::End::goal);
}

TEST_CASE("published: the edge limit keeps tangents of objects of one size and drops what crosses between them") {
  const std::vector<Object> robots{{{0, 0}, kRobot}, {{1, 0.1}, kRobot}, {{2, -0.1}, kRobot}};
  const dvg::Result limited = find(robots, {-2, 0}, {4, 0});
  const dvg::Result all = find(robots, {-2, 0}, {4, 0}, without_limit());
  CHECK(limited.end == dvg::End::goal);
  CHECK(limited.nodes == all.nodes);
  CHECK(limited.edges < all.edges);
  CHECK(length_of(limited.path) >= length_of(all.path));
  const dvg::Result pair = find({{{0, 0}, kRobot}, {{1, 0}, kRobot}}, {-2, 0.01}, {3, 0.01});
  // Along the tops of both, which the limit just leaves.
  CHECK(pair.path.size() == 4);
  CHECK(length_of(pair.path) ==
        Approx(length_of(find({{{0, 0}, kRobot}, {{1, 0}, kRobot}}, {-2, 0.01}, {3, 0.01}, without_limit()).path)));
}

TEST_CASE("published: the shortest path of the graph") {
  std::mt19937_64 random(9);
  DvgParams params = without_limit();
  params.region_half_width_m = 100.0;
  int bent = 0;
  for (int i = 0; i < 12; ++i) {
    std::vector<Object> objects;
    while (objects.size() < 6) objects.push_back({testing::random_point(random, {{1.0, 0.7}}), kRobot});
    const dvg::Result result = find(objects, {-2, 0.013}, {2, 0.007}, params);
    INFO("case " << i);
    REQUIRE(result.end == dvg::End::goal);
    CHECK(length_of(result.path) == Approx(shortest_m(objects, {-2, 0.013}, {2, 0.007})).epsilon(1e-4));
    bent += result.path.size() > 2 ? 1 : 0;
  }
  CHECK(bent > 6);
}

TEST_CASE("published: without time the path leads as far as the graph does") {
  const std::vector<Object> robots{{{0, 0}, kRobot}, {{1, 0.1}, kRobot}};
  int questions = 0;
  const std::function<bool()> after_ten = [&] { return ++questions > 10; };
  Budget budget;
  budget.out_of_time = &after_ten;
  const dvg::Result result = find(robots, {-2, 0}, {4, 0}, {}, budget);
  CHECK(questions == 11);
  CHECK(result.nodes == 12);
  CHECK(result.path.front() == Vec2(-2, 0));
}

TEST_CASE("published: groups and growth change what is searched") {
  const std::vector<Object> robots{{{0, 0.2}, kRobot}, {{0, -0.2}, kRobot}};
  DvgParams grouped = grouped_dvg_params();
  const dvg::Result one = find(robots, {-2, 0.01}, {2, 0.01}, grouped);
  CHECK(one.objects == 1);
  CHECK(one.path[1].norm() == Approx(0.44));
  DvgParams growing;
  growing.variable_radius = true;
  const dvg::Result large = find({{{0, 0}, kRobot}}, {-3, 0.01}, {3, 0.01}, growing);
  CHECK(large.path[1].norm() == Approx(kRobot + 0.05 * (std::hypot(3, 0.01) - 1.0)));
}

TEST_CASE("dvg goes beyond the active region where it must") {
  std::vector<Obstacle> wall;
  for (int i = -12; i <= 12; ++i) wall.push_back(disc({0, 0.3 * i}, 0.2));
  const ObstacleField field({{5, 5}}, wall);
  const Plan plan = Dvg().plan(field, request_of({-3, 0.1}, {3, 0}));
  CHECK(plan.status == PlanStatus::ok);
  CHECK(plan.length_m < 10.2);
}

TEST_CASE("dvg gives up the edge limit before it gives up") {
  // Two discs of very different size: their outer tangent is shorter than their centres are apart, and nothing else
  // leads through between the walls.
  const ObstacleField field({{5, 5}}, {disc({0, 0}, 2.0), disc({2.9, 1.6}, 0.5), capsule({0, 2.6}, {4, 4.5}, 0.1),
                                       capsule({-0.5, -5}, {0, -1}, 0.2)});
  const Plan plan = Dvg().plan(field, request_of({-4, 0}, {4.5, 0}));
  CHECK(plan.status == PlanStatus::ok);
}

TEST_CASE("dvg_grouped goes round a group that dvg passes through, and through one when it must") {
  const ObstacleField pair({{5, 5}}, {disc({0, 0.24}, 0.21), disc({0.02, -0.23}, 0.21)});
  const PlanRequest request = request_of({-2, 0}, {2, 0});
  const Plan through = Dvg().plan(pair, request);
  const Plan around = DvgGrouped().plan(pair, request);
  CHECK(through.path.size() == 2);
  CHECK(around.status == PlanStatus::ok);
  CHECK(around.length_m > through.length_m + 0.05);
  const ObstacleField gate({{5, 0.46}}, pair.obstacles().empty()
                                            ? std::vector<Obstacle>{}
                                            : std::vector<Obstacle>(pair.obstacles().begin(), pair.obstacles().end()));
  CHECK(DvgGrouped().plan(gate, request).status == PlanStatus::ok);
}

TEST_CASE("the dvg planners find nearly every way there is") {
  for (const char* name : {"dvg", "dvg_grouped"}) {
    const std::unique_ptr<Planner> planner = make_planner(name);
    const std::unique_ptr<Planner> reference = make_planner("tangent");
    int reachable = 0;
    int found = 0;
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
      std::mt19937_64 random(seed);
      const ObstacleField field = testing::random_field(random, seed % 45);
      const PlanRequest request = testing::random_free_request(random, field);
      if (reference->plan(field, request).status != PlanStatus::ok) continue;
      ++reachable;
      const Plan plan = planner->plan(field, request);
      CHECK_FALSE(plan.reason.starts_with("refused"));
      found += plan.status == PlanStatus::ok ? 1 : 0;
    }
    INFO(name);
    CHECK(reachable > 400);
    CHECK(found >= reachable * 99 / 100);
  }
}

TEST_CASE("parameters of the dvg planners are set by name") {
  PlanningParams params;
  CHECK_FALSE(params.dvg.grouping);
  CHECK(params.dvg_grouped.grouping);
  set_param(params, "dvg_grouped.group_distance_m", "1.5");
  set_param(params, "dvg.edge_limit", "false");
  CHECK(params.dvg_grouped.group_distance_m == 1.5);
  CHECK_FALSE(params.dvg.edge_limit);
  set_param(params, "dvg_grouped.grouping", "false");
  const ObstacleField pair({{5, 5}}, {disc({0, 0.24}, 0.21), disc({0.02, -0.23}, 0.21)});
  CHECK(DvgGrouped(params).plan(pair, request_of({-2, 0}, {2, 0})).path.size() == 2);
}

}  // namespace regista
