// The artificial potential field: its force, how it leaves local minima, where it ends.
#include "planning/planners/apf.h"

#include <catch2/catch.hpp>

#include "planning/planners/apf_force.h"
#include "planning/planners/apf_wall.h"
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

double least_clearance_m(const Plan& plan, const Obstacle& obstacle) {
  double least_m = 1e9;
  for (std::size_t i = 1; i < plan.path.size(); ++i) {
    least_m = std::min(least_m, clearance(plan.path[i - 1], plan.path[i], obstacle));
  }
  return least_m;
}

}  // namespace

TEST_CASE("the goal attracts with one, an obstacle repels with one at the distance of balance") {
  const ApfParams params;
  const Vec2 goal(5, 0);
  const auto force = [&](const ObstacleField& field, const Vec2& at, std::span<const std::size_t> ignored = {}) {
    return potential_force(field, ignored, goal, at, params);
  };
  const ObstacleField empty({{9, 9}}, {});
  CHECK((force(empty, {2, 4}) - Vec2(3, -4) / 5.0).norm() < 1e-12);
  for (const Obstacle& ahead :
       {disc({1, 0}, 0.5), capsule({1, -1}, {1, 1}, 0.5), rounded_rectangle({0.6, -1}, {2, 1}, 0.1)}) {
    const ObstacleField field({{9, 9}}, {ahead});
    const double front = 0.5;
    CHECK(force(field, {front - params.balance_m, 0}).norm() < 1e-9);
    CHECK(force(field, {front - 0.5 * params.balance_m, 0}).x() < 0.0);
    CHECK(force(field, {front - params.influence_m - 1e-6, 0}).x() == 1.0);
    CHECK(force(field, {front - params.influence_m + 0.01, 0}).x() < 1.0);
    const std::vector<std::size_t> ignored{0};
    CHECK(force(field, {front - 0.05, 0}, ignored).x() == 1.0);
    CHECK(is_finite(force(field, {front, 0})));
  }
}

TEST_CASE("an obstacle beside the goal does not keep the robot away") {
  const ObstacleField field({{5, 5}}, {disc({1, 0.25}, 0.21)});
  const Plan plan = Apf().plan(field, request_of({-2, 0}, {1, 0}));
  CHECK(plan.status == PlanStatus::ok);
  CHECK(plan.length_m < 3.3);
  // Nearer to the obstacle than the balance, and still drawn to the goal beside it.
  const Vec2 at(0.97, 0.0);
  CHECK(clearance(at, field.obstacles()[0]) < 0.05);
  CHECK(potential_force(field, {}, {1, 0}, at, {}).x() > 0.9);
}

TEST_CASE("the field alone leads straight where nothing is, and past obstacles at a distance") {
  const ObstacleField empty({{5, 5}}, {});
  CHECK(Apf().plan(empty, request_of({-2, 1}, {3, 0})).path == std::vector<Vec2>{{-2, 1}, {3, 0}});
  const ObstacleField beside({{5, 5}}, {disc({0, 0.05}, 0.21)});
  const Plan plan = Apf().plan(beside, request_of({-2, 0}, {2, 0}));
  REQUIRE(plan.status == PlanStatus::ok);
  CHECK(least_clearance_m(plan, beside.obstacles()[0]) > 0.05);
  CHECK(plan.length_m < 4.4);
}

TEST_CASE("local minima are left") {
  const ObstacleField symmetric({{5, 5}}, {disc({0, 0}, 0.5)});
  const Plan round = Apf().plan(symmetric, request_of({-2, 0}, {2, 0}));
  CHECK(round.status == PlanStatus::ok);
  CHECK(round.length_m < 4.8);
  const ObstacleField trap({{5, 5}},
                           {rounded_rectangle({0.9, -1}, {1, 1}, 0.1), rounded_rectangle({-1, 0.9}, {1, 1}, 0.1),
                            rounded_rectangle({-1, -1}, {1, -0.9}, 0.1)});
  const Plan out = Apf().plan(trap, request_of({0, 0}, {3, 0}));
  CHECK(out.status == PlanStatus::ok);
  CHECK(out.length_m < 9.0);
  // The shorter side: the wall's lower end is nearer.
  const ObstacleField wall({{5, 5}}, {rounded_rectangle({-0.1, -1}, {0.1, 4}, 0.1)});
  const Plan under = Apf().plan(wall, request_of({-2, 0}, {2, 0}));
  CHECK(under.status == PlanStatus::ok);
  CHECK(under.length_m < 6.0);
}

TEST_CASE("a wall that goes all the way round ends the search, and so do steps and time") {
  Apf planner;
  const ObstacleField ring({{5, 5}}, testing::ring_around({0, 0}, 1.0));
  for (const PlanRequest& request : {request_of({0, 0}, {3, 0}), request_of({3, 0}, {0, 0})}) {
    const Plan plan = planner.plan(ring, request);
    CHECK(plan.status == PlanStatus::not_found);
    CHECK_THAT(plan.reason, Catch::Contains("leads round"));
  }
  ApfParams few;
  few.steps_max = 10;
  const ObstacleField empty({{5, 5}}, {});
  const Plan tired = Apf(few).plan(empty, request_of({-2, 0}, {2, 0}));
  CHECK(tired.status == PlanStatus::not_found);
  CHECK_THAT(tired.reason, Catch::Contains("steps"));
  CHECK(tired.length_m > 0.3);
  PlanRequest hurried = request_of({-2, 0}, {2, 0});
  int questions = 0;
  const std::function<bool()> after_two = [&] { return ++questions > 2; };
  hurried.budget.out_of_time = &after_two;
  CHECK_THAT(planner.plan(empty, hurried).reason, Catch::Contains("time"));
  CHECK(questions == 3);
}

TEST_CASE("a hand on the wall goes round a disc, on either side, and stays free") {
  const ObstacleField field({{5, 5}}, {disc({0, 0}, 0.5)});
  for (const double side : {-1.0, 1.0}) {
    // The goal lies within the disc, so the walk never leaves.
    WallFollower walker(field, {}, {-0.52, 0}, {0, 0}, side, 0.05);
    int steps = 0;
    while (walker.end() == WallFollower::End::walking && ++steps < 1000) walker.step();
    CHECK(walker.end() == WallFollower::End::around);
    CHECK(steps > 55);
    CHECK(steps < 80);
    Vec2 before(-0.52, 0);
    for (const Vec2& point : walker.path()) {
      CHECK(field.is_free(before, point));
      CHECK(point.norm() < 0.6);
      before = point;
    }
    CHECK(side * walker.path()[5].y() > 0.0);
  }
}

TEST_CASE("the potential field finds nearly every way there is, and not by long detours") {
  Apf planner;
  const std::unique_ptr<Planner> reference = make_planner("tangent");
  int reachable = 0;
  int found = 0;
  double length_m = 0.0;
  double least_m = 0.0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    std::mt19937_64 random(seed);
    const ObstacleField field = testing::random_field(random, seed % 45);
    const PlanRequest request = testing::random_free_request(random, field);
    const Plan shortest = reference->plan(field, request);
    if (shortest.status != PlanStatus::ok) continue;
    ++reachable;
    const Plan plan = planner.plan(field, request);
    if (plan.status != PlanStatus::ok) continue;
    ++found;
    length_m += plan.length_m;
    least_m += shortest.length_m;
  }
  CHECK(reachable > 400);
  CHECK(found >= reachable * 98 / 100);
  CHECK(length_m < 1.1 * least_m);
}

}  // namespace regista
