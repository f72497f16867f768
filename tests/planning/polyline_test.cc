// Pulling paths straight and keeping them.
#include "planning/polyline.h"

#include <catch2/catch.hpp>

#include "planning/kd_tree.h"
#include "planning/planner.h"
#include "tests/support/planning_worlds.h"

namespace regista {
namespace {

const ObstacleField kField({{5, 5}}, {rounded_rectangle({-1, -1}, {1, 1}, 0)});

Query query_of(const Vec2& start, const Vec2& goal, const std::vector<Vec2>& previous) {
  return {start, goal, {}, 1, {}, previous};
}

}  // namespace

TEST_CASE("pruning keeps the ends and what is needed between") {
  const std::vector<Vec2> path{{-3, 0}, {-2, 1}, {-1.2, 1.2}, {0, 1.2}, {1.2, 1.2}, {3, 0}};
  CHECK(pruned(kField, path, {}) == std::vector<Vec2>{{-3, 0}, {-1.2, 1.2}, {1.2, 1.2}, {3, 0}});
  const std::vector<std::size_t> ignored{0};
  CHECK(pruned(kField, path, ignored) == std::vector<Vec2>{{-3, 0}, {3, 0}});
  CHECK(pruned(kField, std::vector<Vec2>{{1, 2}}, {}) == std::vector<Vec2>{{1, 2}});
  CHECK(pruned(kField, {}, {}).empty());
}

TEST_CASE("a previous path is kept while it is free and leads to the goal") {
  const std::vector<Vec2> previous{{-3, 0}, {-1.2, 1.2}, {1.2, 1.2}, {3, 0}};
  using Path = std::vector<Vec2>;
  const Path kept{{-2.5, 0}, {-1.2, 1.2}, {1.2, 1.2}, {3, 0}};
  CHECK(*kept_path(kField, query_of({-2.5, 0}, {3, 0}, previous), 0.1) == kept);
  CHECK(*kept_path(kField, query_of({0, 1.2}, {3, 0}, previous), 0.1) == Path{{0, 1.2}, {1.2, 1.2}, {3, 0}});
  CHECK(*kept_path(kField, query_of({1.2, 1.2}, {3, 0}, previous), 0.1) == Path{{1.2, 1.2}, {3, 0}});
  const Path drifted{{-2.5, 0}, {-1.2, 1.2}, {1.2, 1.2}, {3, 0.05}};
  CHECK(*kept_path(kField, query_of({-2.5, 0}, {3, 0.05}, previous), 0.1) == drifted);
  CHECK_FALSE(kept_path(kField, query_of({-2.5, 0}, {3, 0.2}, previous), 0.1));
  CHECK_FALSE(kept_path(kField, query_of({-2.5, 0}, {3, 0}, {}), 0.1));
  const ObstacleField blocked({{5, 5}}, {kField.obstacles()[0], disc({0, 1.3}, 0.2)});
  CHECK_FALSE(kept_path(blocked, query_of({-2.5, 0}, {3, 0}, previous), 0.1));
}

TEST_CASE("the tree's nearest point is the nearest") {
  std::mt19937_64 random(16);
  KdTree tree(500);
  CHECK(std::isinf(tree.nearest({0, 0}).distance_m));
  std::vector<Vec2> points;
  for (int i = 0; i < 500; ++i) {
    points.push_back(testing::random_point(random, {{5, 5}}));
    tree.add(points.back());
    const Vec2 wanted = testing::random_point(random, {{5, 5}});
    double least = 1e9;
    for (const Vec2& point : points) least = std::min(least, (point - wanted).norm());
    REQUIRE(tree.nearest(wanted).distance_m == Approx(least));
    REQUIRE((tree[tree.nearest(wanted).index] - wanted).norm() == Approx(least));
  }
}

}  // namespace regista
