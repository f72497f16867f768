// A* on a grid: the shortest way over the grid, and what a grid cannot do.
#include "planning/planners/astar_grid.h"

#include <catch2/catch.hpp>

#include "tests/support/planning_worlds.h"

namespace regista {
namespace {

PlanRequest request_of(const Vec2& start, const Vec2& goal) {
  PlanRequest request;
  request.start = start;
  request.goal = goal;
  return request;
}

AstarGridParams cells_of(double side_m) {
  AstarGridParams params;
  params.cell_m = side_m;
  return params;
}

/// On a grid of 20 × 16 cells of 0.1 m: least cost from one cell to the other by relaxing all legs over and over;
/// every leg is asked for.
double least_cost_m(const ObstacleField& field, int from, int to) {
  constexpr int kColumns = 20;
  constexpr int kRows = 16;
  constexpr double kCell = 0.1;
  const auto centre = [&](int i) {
    return Vec2((i % kColumns - kColumns / 2 + 0.5) * kCell, (i / kColumns - kRows / 2 + 0.5) * kCell);
  };
  std::vector<double> cost(kColumns * kRows, 1e9);
  cost[static_cast<std::size_t>(from)] = 0.0;
  for (bool changed = true; changed;) {
    changed = false;
    for (int i = 0; i < kColumns * kRows; ++i) {
      for (int j = 0; j < kColumns * kRows; ++j) {
        const double leg_m = (centre(i) - centre(j)).norm();
        if (i == j || leg_m > 1.5 * kCell) continue;
        const double through = cost[static_cast<std::size_t>(i)] + leg_m;
        if (through >= cost[static_cast<std::size_t>(j)] - 1e-12 || !field.is_free(centre(i), centre(j))) continue;
        cost[static_cast<std::size_t>(j)] = through;
        changed = true;
      }
    }
  }
  return cost[static_cast<std::size_t>(to)];
}

}  // namespace

TEST_CASE("a grid's path turns at centres of cells and goes in eight directions") {
  const ObstacleField field({{6, 4.5}}, {disc({0, 0}, 0.5), capsule({1, -2}, {2, 1}, 0.3)});
  const Plan plan = AstarGrid().plan(field, request_of({-3.01, 0.013}, {3.017, -0.4}));
  REQUIRE(plan.status == PlanStatus::ok);
  REQUIRE(plan.path.size() > 4);
  for (std::size_t i = 1; i + 1 < plan.path.size(); ++i) {
    for (const double coordinate : {plan.path[i].x(), plan.path[i].y()}) {
      const double cells = coordinate / 0.05 - 0.5;
      CHECK(std::abs(cells - std::round(cells)) < 1e-9);
    }
    if (i + 2 >= plan.path.size()) continue;
    const Vec2 leg = (plan.path[i + 1] - plan.path[i]).cwiseAbs();
    CHECK((leg.minCoeff() < 1e-9 || std::abs(leg.x() - leg.y()) < 1e-9));
  }
  CHECK((plan.path[1] - plan.path[0]).norm() < 0.05 * std::numbers::sqrt2);
}

TEST_CASE("the path over the grid is the shortest one") {
  const Bounds bounds{{1.0, 0.8}};
  AstarGrid planner(cells_of(0.1));
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    std::mt19937_64 random(seed);
    std::vector<Obstacle> obstacles;
    for (int i = 0; i < 12; ++i) obstacles.push_back(disc(testing::random_point(random, bounds), 0.13));
    const ObstacleField field(bounds, obstacles);
    // Cells 21 and 298 of 320: one in from either corner.
    const PlanRequest request = request_of({-0.85, -0.65}, {0.85, 0.65});
    if (!field.is_free(request.start) || !field.is_free(request.goal)) continue;
    const Plan plan = planner.plan(field, request);
    const double least_m = least_cost_m(field, 21, 298);
    INFO("seed " << seed);
    CHECK((plan.status == PlanStatus::ok) == (least_m < 1e8));
    if (plan.status == PlanStatus::ok) CHECK(plan.length_m == Approx(least_m).epsilon(1e-9));
    ++compared;
  }
  CHECK(compared > 20);
}

TEST_CASE("a way narrower than a cell may be missed, a finer grid finds it") {
  // A gap of 30 mm beside the middle, where the centres of 50 mm cells are not.
  const ObstacleField field({{2, 2}}, {rounded_rectangle({-0.1, 0.015}, {0.1, 2.5}, 0.0),
                                       rounded_rectangle({-0.1, -2.5}, {0.1, -0.015}, 0.0)});
  const PlanRequest request = request_of({-1, 0.3}, {1, 0.2});
  const Plan coarse = AstarGrid().plan(field, request);
  CHECK(coarse.status == PlanStatus::not_found);
  CHECK(coarse.path.size() > 1);
  CHECK(AstarGrid(cells_of(0.01)).plan(field, request).status == PlanStatus::ok);
}

TEST_CASE("a start beside obstacles is joined to centres farther off") {
  // None of the four centres around the start is in sight.
  const Vec2 start(0.0, 0.0);
  std::vector<Obstacle> box;
  for (const double side : {-1.0, 1.0}) {
    box.push_back(rounded_rectangle({side * 0.01, -0.06}, {side * 0.06, 0.06}, 0.0));
  }
  const ObstacleField field({{2, 2}}, box);
  const Plan plan = AstarGrid().plan(field, request_of(start, {1, 1}));
  CHECK(plan.status == PlanStatus::ok);
}

TEST_CASE("a start that sees no cell, a field without cells, and one with too many have no path and a reason") {
  const ObstacleField pocket(
      {{2, 2}}, {rounded_rectangle({0.001, -1}, {0.3, 1}, 0), rounded_rectangle({-0.3, -1}, {-0.001, 1}, 0),
                 rounded_rectangle({-0.3, 0.001}, {0.3, 1}, 0), rounded_rectangle({-0.3, -1}, {0.3, -0.001}, 0)});
  AstarGrid planner;
  const Plan stuck = planner.plan(pocket, request_of({0, 0}, {1, 1}));
  CHECK(stuck.status == PlanStatus::not_found);
  CHECK_THAT(stuck.reason, Catch::Contains("no way"));
  const ObstacleField line({{3, 0.01}}, {});
  CHECK_THAT(planner.plan(line, request_of({-1, 0}, {1, 0})).reason, Catch::Contains("no cell or too many"));
  const ObstacleField vast({{1e6, 1e6}}, {});
  CHECK_THAT(planner.plan(vast, request_of({-1, 0}, {1, 0})).reason, Catch::Contains("no cell or too many"));
  CHECK(planner.plan(ObstacleField({{2, 2}}, {}), request_of({-1, 0}, {1, 0})).status == PlanStatus::ok);
}

}  // namespace regista
