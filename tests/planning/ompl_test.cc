// The planners taken from OMPL: reproducible in spite of its global seeds, their parameters, silence. The common laws
// are examined with every planner of the registry.
#include <catch2/catch.hpp>
#include <iostream>
#include <numbers>
#include <sstream>

#include "planning/planners/ompl/ompl_planner.h"
#include "planning/registry.h"
#include "tests/support/planning_worlds.h"

namespace regista {
namespace {

constexpr std::array<std::string_view, 5> kNames{"rrt_star", "fmt_star", "bit_star", "rrt_connect",
                                                 "informed_rrt_star"};
constexpr std::array<std::string_view, 3> kAnytime{"rrt_star", "bit_star", "informed_rrt_star"};

PlanRequest request_of(const Vec2& start, const Vec2& goal, std::int64_t iterations, std::uint64_t seed = 1) {
  PlanRequest request;
  request.start = start;
  request.goal = goal;
  request.seed = seed;
  request.budget.iterations = iterations;
  return request;
}

ObstacleField one_disc() { return {testing::test_bounds(), {disc({0, 0}, 0.5)}}; }

bool is_ok(const Plan& plan) { return plan.status == PlanStatus::ok; }

/// Another planner and query, and blocks of memory that stay, so that nothing lies where it lay before.
void disturb(std::mt19937_64& random, std::vector<std::vector<char>>& blocks) {
  const ObstacleField field = testing::random_field(random, 15);
  const std::string_view name = kNames[random() % kNames.size()];
  make_planner(name)->plan(field, testing::random_request(random, field));
  for (int i = 0; i < 20; ++i) blocks.emplace_back(16 + random() % 500);
}

PlanningParams with(const OmplParams& ompl) {
  PlanningParams params;
  params.ompl = ompl;
  return params;
}

}  // namespace

TEST_CASE("an answer of OMPL's planners depends on its query alone") {
  for (const std::string_view name : kNames) {
    for (const bool simplify : {false, true}) {
      std::mt19937_64 random(17);
      std::vector<std::vector<char>> blocks;
      OmplParams ompl;
      ompl.simplify = simplify;
      const std::unique_ptr<Planner> planner = make_planner(name, with(ompl));
      for (int i = 0; i < 8; ++i) {
        const ObstacleField field = testing::random_field(random, 25);
        PlanRequest request = testing::random_free_request(random, field);
        request.budget.iterations = 700;
        const Plan plan = planner->plan(field, request);
        disturb(random, blocks);
        INFO(name << ", world " << i);
        CHECK(planner->plan(field, request) == plan);
        CHECK(make_planner(name, with(ompl))->plan(field, request) == plan);
      }
    }
  }
}

TEST_CASE("another seed is another path") {
  for (const std::string_view name : kNames) {
    const std::unique_ptr<Planner> planner = make_planner(name);
    const Plan one = planner->plan(one_disc(), request_of({-3, 0}, {3, 0.1}, 500, 1));
    const Plan other = planner->plan(one_disc(), request_of({-3, 0}, {3, 0.1}, 500, 2));
    INFO(name);
    REQUIRE(is_ok(one));
    REQUIRE(is_ok(other));
    CHECK(one.path != other.path);
  }
}

TEST_CASE("more budget makes no path of an anytime planner longer, and it comes near the shortest") {
  // Two tangents and the arc between them, where they touch at the angle acos(r / d) from start and goal.
  const double tangent_m = std::sqrt(9.0 - 0.25);
  const double shortest_m = 2.0 * tangent_m + 0.5 * (std::numbers::pi - 2.0 * std::acos(0.5 / 3.0));
  for (const std::string_view name : kAnytime) {
    const std::unique_ptr<Planner> planner = make_planner(name);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      double before_m = 1e9;
      for (const std::int64_t iterations : {300, 600, 1200, 2400}) {
        const Plan plan = planner->plan(one_disc(), request_of({-3, 0}, {3, 0}, iterations, seed));
        INFO(name << ", seed " << seed << ", " << iterations << " iterations");
        REQUIRE(is_ok(plan));
        CHECK(plan.length_m <= before_m + 1e-9);
        CHECK(plan.length_m >= shortest_m - 1e-9);
        before_m = plan.length_m;
      }
      CHECK(before_m < 1.02 * shortest_m);
    }
  }
}

TEST_CASE("a free straight line costs no budget") {
  for (const std::string_view name : kNames) {
    const Plan plan = make_planner(name)->plan(one_disc(), request_of({-3, 2}, {3, 2}, 0));
    CHECK(is_ok(plan));
    CHECK(plan.path == std::vector<Vec2>{{-3, 2}, {3, 2}});
  }
}

TEST_CASE("the range is the longest motion of RRT-Connect") {
  OmplParams ompl;
  ompl.range_m = 0.4;
  const Plan plan = RrtConnect(ompl).plan(one_disc(), request_of({-3, 0}, {3, 0}, 1000));
  REQUIRE(is_ok(plan));
  for (std::size_t i = 1; i < plan.path.size(); ++i) {
    CHECK((plan.path[i] - plan.path[i - 1]).norm() < 0.4 + 1e-12);
  }
  CHECK(RrtConnect(OmplParams{}).plan(one_disc(), request_of({-3, 0}, {3, 0}, 1000)).path.size() < plan.path.size());
}

TEST_CASE("the goal bias is the share of the samples at the goal") {
  // Nothing but the goal is drawn, and it is behind the disc.
  OmplParams ompl;
  ompl.goal_bias = 1.0;
  CHECK_FALSE(is_ok(RrtStar(ompl).plan(one_disc(), request_of({-3, 0}, {3, 0}, 500))));
  CHECK_FALSE(is_ok(InformedRrtStar(ompl).plan(one_disc(), request_of({-3, 0}, {3, 0}, 500))));
  ompl.goal_bias = 0.05;
  CHECK(is_ok(RrtStar(ompl).plan(one_disc(), request_of({-3, 0}, {3, 0}, 500))));
}

TEST_CASE("a batch is what FMT* begins with") {
  // 20 evaluations draw 20 samples of the hundred: the budget ends before the search begins.
  CHECK_FALSE(is_ok(FmtStar().plan(one_disc(), request_of({-3, 0}, {3, 0}, 20))));
  OmplParams few;
  few.samples_per_batch = 10;
  int found = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    found += is_ok(FmtStar(few).plan(one_disc(), request_of({-3, 0}, {3, 0}, 20, seed))) ? 1 : 0;
  }
  CHECK(found > 5);
}

TEST_CASE("simplifying makes the paths of RRT-Connect shorter") {
  std::mt19937_64 random(4);
  OmplParams ompl;
  ompl.simplify = true;
  RrtConnect simplifying(ompl);
  RrtConnect plain;
  double plain_m = 0.0;
  double simplified_m = 0.0;
  for (int i = 0; i < 50; ++i) {
    const ObstacleField field = testing::random_field(random, 20);
    const PlanRequest request = testing::random_free_request(random, field);
    const Plan one = plain.plan(field, request);
    const Plan other = simplifying.plan(field, request);
    CHECK(one.status == other.status);
    plain_m += one.length_m;
    simplified_m += other.length_m;
  }
  CHECK(simplified_m < 0.95 * plain_m);
}

TEST_CASE("fields without width and ends on the border are no exceptions") {
  const ObstacleField line({{5, 0}}, {disc({0, 0}, 0.5)});
  const ObstacleField border(testing::test_bounds(), {disc({0, testing::kHalfWidth_m}, 0.5)});
  const double y = testing::kHalfWidth_m + 0.9 * kTouch_m;
  for (const std::string_view name : kNames) {
    INFO(name);
    CHECK(make_planner(name)->plan(line, request_of({-3, 0}, {3, 0}, 500)).status == PlanStatus::not_found);
    CHECK(is_ok(make_planner(name)->plan(border, request_of({-3, y}, {3, y}, 1000))));
  }
}

TEST_CASE("OMPL says nothing on the console") {
  std::ostringstream said;
  std::streambuf* const out = std::cout.rdbuf(said.rdbuf());
  std::streambuf* const error = std::cerr.rdbuf(said.rdbuf());
  for (const std::string_view name : kNames) make_planner(name)->plan(one_disc(), request_of({-3, 0}, {3, 0}, 200));
  std::cout.rdbuf(out);
  std::cerr.rdbuf(error);
  CHECK(said.str().empty());
}

}  // namespace regista
