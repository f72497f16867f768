// DVG+A* as published: what its graph holds, and the shortest path of it against brute force.
#include "planning/planners/dvg_published.h"

#include <catch2/catch.hpp>

#include "planning/planner.h"
#include "tests/planning/octagon.h"
#include "tests/support/planning_worlds.h"

namespace regista {
namespace {

using dvg::Object;
using testing::depth;
using testing::direction;

constexpr double kRobot = dvg::kRobotObject_m;

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

}  // namespace regista
