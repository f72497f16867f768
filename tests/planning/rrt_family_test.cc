// The rapidly exploring random trees that are written here: what the papers say of each one beyond the common laws.
#include <catch2/catch.hpp>

#include "planning/planners/errt.h"
#include "planning/planners/irrt.h"
#include "planning/planners/rrt.h"
#include "planning/planners/rrt_plan.h"
#include "planning/planners/rrt_tree.h"
#include "tests/support/planning_worlds.h"

namespace regista {
namespace {

constexpr int kSeeds = 200;

PlanRequest request_of(const Vec2& start, const Vec2& goal, std::uint64_t seed = 1) {
  PlanRequest request;
  request.start = start;
  request.goal = goal;
  request.seed = seed;
  return request;
}

Query query_of(const PlanRequest& request) {
  return {request.start, request.goal, request.ignored, request.seed, request.budget, request.previous_path};
}

ObstacleField one_disc() { return {testing::test_bounds(), {disc({0, 0}, 0.5)}}; }

/// A wall across the field with a gap at y = 3.
ObstacleField wall_with_gap(double gap_m) {
  const double far = 0.5 * gap_m + 0.1;
  return {testing::test_bounds(),
          {rounded_rectangle({-0.1, -6}, {0.1, 3 - far}, 0.1), rounded_rectangle({-0.1, 3 + far}, {0.1, 6}, 0.1)}};
}

bool is_ok(const Plan& plan) { return plan.status == PlanStatus::ok; }

/// Of kSeeds seeds, those whose plan is ok.
int successes(Planner& planner, const ObstacleField& field, PlanRequest request) {
  int count = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    request.seed = static_cast<std::uint64_t>(seed);
    count += is_ok(planner.plan(field, request)) ? 1 : 0;
  }
  return count;
}

}  // namespace

TEST_CASE("steps have the length asked for, the last leg the reach") {
  const ObstacleField field = one_disc();
  const PlanRequest request = request_of({-3, 0}, {3, 0});
  const Query query = query_of(request);
  for (const bool fixed : {true, false}) {
    std::mt19937_64 random(5);
    const RrtSteps steps{.step_m = 1.0, .goal_reach_m = 0.1, .fixed = fixed};
    const auto draw = [&] { return uniform_point(random, field.bounds()); };
    const RrtBranch branch = grow_rrt(field, query, steps, 20000, draw);
    REQUIRE(branch.end == RrtEnd::goal);
    REQUIRE(branch.path.size() > 5);
    CHECK(branch.path.front() == query.start);
    CHECK(branch.path.back() == query.goal);
    int shorter = 0;
    for (std::size_t i = 1; i + 1 < branch.path.size(); ++i) {
      const double leg_m = (branch.path[i] - branch.path[i - 1]).norm();
      CHECK(leg_m < 1.0 + 1e-12);
      shorter += leg_m < 1.0 - 1e-12 ? 1 : 0;
    }
    CHECK((shorter == 0) == fixed);
    CHECK((branch.path.back() - branch.path[branch.path.size() - 2]).norm() <= 0.1);
  }
}

TEST_CASE("a tree without samples is its root, one without time asks for it once") {
  const ObstacleField field = one_disc();
  PlanRequest request = request_of({-3, 0}, {3, 0});
  const RrtSteps steps{.step_m = 0.3, .goal_reach_m = 0.3};
  const auto goal = [&] { return request.goal; };
  const RrtBranch root = grow_rrt(field, query_of(request), steps, 0, goal);
  CHECK(root.end == RrtEnd::samples_spent);
  CHECK(root.path == std::vector<Vec2>{request.start});
  int questions = 0;
  const std::function<bool()> always = [&questions] { return ++questions > 0; };
  request.budget.out_of_time = &always;
  CHECK(grow_rrt(field, query_of(request), steps, 1000, goal).end == RrtEnd::no_time);
  CHECK(questions == 1);
}

TEST_CASE("a tree that does not arrive leads to its node nearest to the goal") {
  const ObstacleField field(testing::test_bounds(), testing::ring_around({3, 0}, 1.0));
  for (Planner* planner : std::initializer_list<Planner*>{new RrtPlan, new Irrt, new Errt, new Rrt}) {
    const std::unique_ptr<Planner> owner(planner);
    const Plan plan = planner->plan(field, request_of({-3, 0}, {3, 0}));
    CHECK(plan.status == PlanStatus::not_found);
    REQUIRE(plan.path.size() > 1);
    CHECK((plan.path.back() - Vec2(3, 0)).norm() < 2.5);
  }
}

TEST_CASE("smoothing keeps nodes of the tree, sees past the others and makes no path longer") {
  std::mt19937_64 random(3);
  int smoothed = 0;
  for (int i = 0; i < kSeeds; ++i) {
    const ObstacleField field = testing::random_field(random, 20);
    const PlanRequest request = testing::random_free_request(random, field);
    const Plan raw = RrtPlan().plan(field, request);
    const Plan smooth = RrtSmooth().plan(field, request);
    CHECK(raw.status == smooth.status);
    CHECK(smooth.length_m <= raw.length_m + 1e-9);
    CHECK(std::includes(raw.path.begin(), raw.path.end(), smooth.path.begin(), smooth.path.end(),
                        [&](const Vec2& a, const Vec2& b) {
                          const auto at = [&](const Vec2& p) { return std::find(raw.path.begin(), raw.path.end(), p); };
                          return at(a) < at(b);
                        }));
    for (std::size_t k = 2; k < smooth.path.size(); ++k) {
      CHECK_FALSE(field.is_free(smooth.path[k - 2], smooth.path[k], request.ignored));
    }
    smoothed += smooth.path.size() < raw.path.size() ? 1 : 0;
  }
  CHECK(smoothed > 10);
}

TEST_CASE("the iterative tree stays within its first rectangle where that suffices") {
  const ObstacleField field = one_disc();
  PlanningParams params;
  params.irrt.first_width_m = 2.0;
  params.irrt.epsilon_m = 0.2;
  Irrt planner(params);
  for (int seed = 0; seed < kSeeds; ++seed) {
    const Plan plan = planner.plan(field, request_of({-3, 0}, {3, 0}, static_cast<std::uint64_t>(seed)));
    REQUIRE(is_ok(plan));
    for (const Vec2& point : plan.path) CHECK(std::abs(point.y()) <= 1.0);
  }
}

TEST_CASE("the iterative tree widens its rectangle until there is a way") {
  const ObstacleField field = wall_with_gap(1.0);
  const PlanRequest request = request_of({-3, -3}, {3, -3});
  Irrt planner;
  CHECK(successes(planner, field, request) == kSeeds);
  double farthest_m = 0.0;
  for (const Vec2& point : planner.plan(field, request).path) farthest_m = std::max(farthest_m, point.y() + 3.0);
  CHECK(farthest_m > 5.4);
}

TEST_CASE("two trees and the better path are shorter than one tree") {
  std::mt19937_64 random(8);
  double one_m = 0.0;
  double two_m = 0.0;
  for (int i = 0; i < kSeeds; ++i) {
    const ObstacleField field = testing::random_field(random, 20);
    const PlanRequest request = testing::random_free_request(random, field);
    const Plan one = RrtPlan().plan(field, request);
    const Plan two = Irrt().plan(field, request);
    if (!is_ok(one) || !is_ok(two)) continue;
    one_m += one.length_m;
    two_m += two.length_m;
  }
  CHECK(two_m < one_m);
}

TEST_CASE("the extended tree finds again where it went before") {
  const ObstacleField field = wall_with_gap(0.4);
  PlanRequest request = request_of({-3, 1}, {3, 1}, 77);
  request.budget.iterations = 100000;
  Errt planner;
  const Plan before = planner.plan(field, request);
  REQUIRE(is_ok(before));
  request.budget.iterations = 1000;
  const int without = successes(planner, field, request);
  request.previous_path = before.path;
  const int with = successes(planner, field, request);
  CHECK(with > kSeeds * 9 / 10);
  CHECK(without < with / 2);
  PlanningParams params;
  params.errt.waypoint_bias = 0.0;
  Errt forgetful(params);
  CHECK(successes(forgetful, field, request) < with / 2);
}

TEST_CASE("the extended tree takes the printed step of 15 mm as well") {
  PlanningParams params;
  params.errt.step_m = 0.015;
  const Plan plan = Errt(params).plan(one_disc(), request_of({-1, 0}, {1, 0.2}));
  REQUIRE(is_ok(plan));
  for (std::size_t i = 1; i < plan.path.size(); ++i) {
    CHECK((plan.path[i] - plan.path[i - 1]).norm() < 0.015 + 1e-12);
  }
}

TEST_CASE("trees that keep a previous path answer it as long as it is free and leads to the goal") {
  const ObstacleField field = one_disc();
  PlanRequest request = request_of({-3, 0}, {3, 0});
  request.previous_path = {{-3.1, 0}, {0, 0.75}, {3, 0}};
  const std::vector<Vec2> kept{{-3, 0}, {0, 0.75}, {3, 0}};
  CHECK(Rrt().plan(field, request).path == kept);
  CHECK(RrtPlan().plan(field, request).path == kept);
  CHECK(RrtSmooth().plan(field, request).path == kept);
  CHECK(Irrt().plan(field, request).path == kept);
  CHECK(IrrtSmooth().plan(field, request).path == kept);
  request.previous_path = {{-3.1, 0}, {0, 0.4}, {3, 0}};
  CHECK(is_ok(Irrt().plan(field, request)));
  request.previous_path = {{-3.1, 0}, {0, 0.75}, {3, 1}};
  CHECK(Irrt().plan(field, request).path != kept);
}

}  // namespace regista
