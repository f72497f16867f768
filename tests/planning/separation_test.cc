// Whether obstacles close every way, by topology, against the judge that tries all ways.
#include "planning/graph/separation.h"

#include <catch2/catch.hpp>

#include "tests/support/planning_oracles.h"
#include "tests/support/planning_worlds.h"
#include "tests/support/share.h"
#include "tests/support/tangent_oracle.h"
#include "tests/support/varied_worlds.h"

namespace regista {
namespace {

bool separates(const ObstacleField& field, const Vec2& start, const Vec2& goal,
               std::span<const std::size_t> ignored = {}) {
  std::vector<graph::Overlap> overlaps;
  graph::append_overlaps(field, overlaps);
  return graph::Separation().separates(field, overlaps, start, goal, ignored);
}

}  // namespace

TEST_CASE("a ring separates, a ring with a gap does not") {
  const Bounds bounds = testing::test_bounds();
  std::vector<Obstacle> ring = testing::ring_around({1, 0}, 1.0);
  CHECK(separates({bounds, ring}, {1, 0}, {4, 0}));
  CHECK(separates({bounds, ring}, {4, 0}, {1, 0}));
  CHECK_FALSE(separates({bounds, ring}, {1, 0}, {1.3, 0.2}));
  CHECK_FALSE(separates({bounds, ring}, {-4, 0}, {4, 0}));
  ring.erase(ring.begin(), ring.begin() + 2);
  CHECK_FALSE(separates({bounds, ring}, {1, 0}, {4, 0}));
}

TEST_CASE("walls separate with the bounds' help") {
  const Bounds bounds{{4, 2}};
  const Obstacle wall = rounded_rectangle({-0.1, -3}, {0.1, 3}, 0.1);
  CHECK(separates({bounds, {wall}}, {-1, 0}, {1, 0}));
  const std::vector<std::size_t> ignored{0};
  CHECK_FALSE(separates({bounds, {wall}}, {-1, 0}, {1, 0}, ignored));
  CHECK_FALSE(separates({bounds, {rounded_rectangle({-0.1, -3}, {0.1, 1.5}, 0.1)}}, {-1, 0}, {1, 0}));
  CHECK(separates({bounds, {capsule({0, -2}, {0, 0.5}, 0.2), disc({0.1, 1.2}, 0.9)}}, {-1, 0}, {1.5, 0}));
}

TEST_CASE("touching leaves a way") {
  const Bounds bounds{{4, 0.9}};
  const std::vector<Obstacle> gate{disc({0, 0.5}, 0.5), disc({0, -0.5}, 0.5)};
  CHECK_FALSE(separates({bounds, gate}, {-1, 0}, {1, 0}));
  CHECK(separates({bounds, {disc({0, 0.5}, 0.5), disc({0, -0.5}, 0.51)}}, {-1, 0}, {1, 0}));
}

TEST_CASE("two free points are separated exactly where there is no path") {
  int closed = 0;
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(testing::share_of(6000)); ++seed) {
    std::mt19937_64 random(seed);
    const ObstacleField field =
        seed % 2 == 0 ? testing::random_field(random, 10 + seed % 30) : testing::varied_field(random, 4 + seed % 12);
    const PlanRequest request = testing::random_free_request(random, field);
    if (!testing::point_is_free(field, request.start, request.ignored)) continue;
    if (!testing::point_is_free(field, request.goal, request.ignored)) continue;
    const auto length_m = testing::exact_shortest_length(field, request.start, request.goal, request.ignored);
    closed += length_m ? 0 : 1;
    CAPTURE(seed);
    REQUIRE(separates(field, request.start, request.goal, request.ignored) == !length_m);
  }
  CHECK(closed >= testing::share_of(100));
}

}  // namespace regista
