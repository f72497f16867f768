// DVG+A* for a robot that drives: it finds ways where the published search gives up.
#include "planning/planners/dvg.h"

#include <catch2/catch.hpp>

#include "planning/registry.h"
#include "tests/support/planning_worlds.h"

namespace regista {
namespace {

PlanRequest request_of(const Vec2& start, const Vec2& goal) {
  PlanRequest request;
  request.start = start;
  request.goal = goal;
  return request;
}

}  // namespace

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
