// A bound that is too long would have the exact search answer with a detour; one that is too short only costs time.
#include "planning/graph/detours.h"

#include <catch2/catch.hpp>
#include <random>

#include "tests/support/planning_oracles.h"
#include "tests/support/planning_worlds.h"
#include "tests/support/tangent_oracle.h"
#include "tests/support/varied_worlds.h"

namespace regista::graph {

TEST_CASE("no way is shorter than the bound, and where the bound says that there is none there is none") {
  std::mt19937_64 random(19);
  Detours detours;
  int longer = 0;
  int closed = 0;
  for (int world = 0; world < 4000; ++world) {
    const ObstacleField field = testing::varied_field(random, 1 + random() % 6);
    const PlanRequest request = testing::random_free_request(random, field);
    if (!testing::point_is_free(field, request.start, {}) || !testing::point_is_free(field, request.goal, {})) continue;
    detours.clear();
    for (const Obstacle& obstacle : field.obstacles()) detours.add(obstacle, field.bounds());
    CHECK(detours.size() == field.size());
    const double bound_m = detours.least_m(request.start, request.goal);
    CHECK(bound_m == Approx(detours.least_m(request.goal, request.start)));
    const double straight_m = (request.goal - request.start).norm();
    const std::size_t first = static_cast<std::size_t>(world) % (field.size() + 1);
    const double of_late_m = detours.least_m(request.start, request.goal, first);
    CHECK(of_late_m <= bound_m);
    Detours early;
    for (std::size_t i = 0; i < first; ++i) early.add(field.obstacles()[i], field.bounds());
    CHECK(std::max(early.least_m(request.start, request.goal), of_late_m) == bound_m);
    CHECK(bound_m >= straight_m * (1.0 - 1e-12));
    longer += bound_m > straight_m * (1.0 + 1e-6) ? 1 : 0;
    closed += bound_m > 1e9 ? 1 : 0;
    const std::optional<double> truth_m = testing::exact_shortest_length(field, request.start, request.goal);
    if (truth_m && bound_m > *truth_m + 1e-9) {
      FAIL_CHECK(bound_m << " m is no bound of " << *truth_m << " m: " << testing::pasteable(field, request));
    }
  }
  CHECK(longer > 400);
  CHECK(closed >= 2);
}

TEST_CASE("a disc, a bar and an area right in the way cost nearly what they cost") {
  const Bounds bounds{{6.0, 4.5}};
  const auto share_of_detour = [&](const Obstacle& obstacle, const Vec2& from, const Vec2& to) {
    Detours detours;
    detours.add(obstacle, bounds);
    const double straight_m = (to - from).norm();
    const double truth_m = testing::exact_shortest_length({bounds, {obstacle}}, from, to).value();
    return (detours.least_m(from, to) - straight_m) / (truth_m - straight_m);
  };
  CHECK(share_of_detour(disc({0, 0}, 0.2), {-2, 0.1}, {1.5, 0}) > 0.8);
  CHECK(share_of_detour(capsule({0, -1}, {0.2, 1}, 0.3), {-2, 0.1}, {1.5, 0}) > 0.8);
  // One end of the area is out of bounds.
  CHECK(share_of_detour(rounded_rectangle({4.2, -1.8}, {6.2, 1.8}, 0.1), {5, -3}, {5, 3}) > 0.5);
}

TEST_CASE("a way along the line of a bar, past its end, is as long as it is") {
  const Bounds bounds{{6.0, 4.5}};
  std::mt19937_64 random(20);
  const auto on_grid = [&](int most) { return 0.1 * static_cast<double>(random() % static_cast<unsigned>(most)); };
  for (int i = 0; i < 20000; ++i) {
    const Vec2 step(0.1 + on_grid(5), on_grid(5));
    const Vec2 a(-2.0 - on_grid(10), -2.0 + on_grid(10));
    const Vec2 from = a + 5.0 * step;
    const Vec2 to = a + 7.0 * step;
    Detours detours;
    detours.add(capsule(a, a + step, 0.1), bounds);
    INFO("bar " << i << " of seed 20, from " << a.transpose() << " by " << step.transpose());
    REQUIRE(detours.least_m(from, to) <= (to - from).norm() + 1e-9);
  }
}

}  // namespace regista::graph
