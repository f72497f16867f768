// Samples of obstacles: free of their own obstacle, in sight of their neighbours, mirrored with the world.
#include "planning/graph/samples.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/support/planning_worlds.h"

namespace regista::graph {
namespace {

const Bounds kWide{{100, 100}};

std::vector<Vec2> samples_of(const ObstacleField& field, ObstacleIndex index) {
  std::vector<Vec2> samples;
  append_samples(field, index, samples);
  return samples;
}

bool contains(const std::vector<Vec2>& points, const Vec2& point) {
  return std::find(points.begin(), points.end(), point) != points.end();
}

/// True when one can walk from every sample to every other along free edges.
bool is_connected(const ObstacleField& field, const std::vector<Vec2>& samples) {
  std::vector<std::size_t> reached{0};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (std::size_t k = 0; k < samples.size(); ++k) {
      if (std::find(reached.begin(), reached.end(), k) == reached.end() &&
          field.is_free(samples[reached[i]], samples[k])) {
        reached.push_back(k);
      }
    }
  }
  return reached.size() == samples.size();
}

}  // namespace

TEST_CASE("a lonely disc gets four samples, a near one eight") {
  const std::vector<Obstacle> discs{disc({0, 0}, 0.2), disc({1.5, 0}, 0.2), disc({0, 1.3}, 0.2)};
  CHECK(samples_of({kWide, {discs[0]}}, 0).size() == 4);
  CHECK(samples_of({kWide, {discs[0], discs[1]}}, 0).size() == 4);
  CHECK(samples_of({kWide, {discs[0], discs[2]}}, 0).size() == 8);
}

TEST_CASE("samples outside the bounds are none") {
  CHECK(samples_of({{{1, 1}}, {disc({1, 0}, 0.5)}}, 0).size() == 3);
  CHECK(samples_of({{{6, 4.5}}, {rounded_rectangle({4.2, -1.8}, {6.2, 1.8}, 0.1)}}, 0).size() == 2);
}

TEST_CASE("one can walk round every obstacle over its own samples") {
  std::mt19937_64 random(8);
  for (int i = 0; i < 2000; ++i) {
    const Obstacle obstacle = testing::random_obstacle(random, testing::test_bounds());
    if (obstacle.radius_m == 0.0) continue;
    std::vector<Obstacle> obstacles{obstacle};
    // A neighbour, far from everything else's sight, that makes the samples dense.
    const bool near = i % 2 == 0;
    if (near) obstacles.push_back(disc(obstacle.a, 1e-12));
    const ObstacleField field(kWide, obstacles);
    const std::vector<Vec2> samples = samples_of(field, 0);
    CAPTURE(i, static_cast<int>(obstacle.core), near);
    REQUIRE(samples.size() >= 4);
    REQUIRE(samples.size() <= samples_max(obstacle));
    for (const Vec2& sample : samples) REQUIRE(is_free(sample, obstacle));
    REQUIRE(is_connected(field, samples));
  }
}

TEST_CASE("samples are mirrored with the obstacle, to the bit") {
  std::mt19937_64 random(9);
  for (int i = 0; i < 500; ++i) {
    const ObstacleField field = testing::random_field(random, 5);
    for (const Vec2& signs : {Vec2(-1, 1), Vec2(1, -1)}) {
      const ObstacleField mirror = testing::mirrored(field, signs);
      for (ObstacleIndex k = 0; k < field.size(); ++k) {
        const std::vector<Vec2> samples = samples_of(field, k);
        const std::vector<Vec2> others = samples_of(mirror, k);
        CAPTURE(i, k);
        REQUIRE(samples.size() == others.size());
        for (const Vec2& sample : samples) REQUIRE(contains(others, sample.cwiseProduct(signs)));
      }
    }
  }
}

TEST_CASE("the gap between obstacles is symmetric") {
  std::mt19937_64 random(10);
  for (int i = 0; i < 1000; ++i) {
    const Obstacle one = testing::random_obstacle(random, testing::test_bounds());
    const Obstacle other = testing::random_obstacle(random, testing::test_bounds());
    if (gap(one, other) > -std::min(one.radius_m, other.radius_m)) {
      REQUIRE(gap(one, other) == Approx(gap(other, one)).margin(1e-12));
    }
  }
  CHECK(gap(rounded_rectangle({0, 0}, {1, 1}, 0.5), rounded_rectangle({4, 5}, {6, 6}, 0.5)) == Approx(4));
}

}  // namespace regista::graph
