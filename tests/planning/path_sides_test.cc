// Which side of an obstacle a path passes, compared with another path.
#include "planning/path_sides.h"

#include <catch2/catch.hpp>

#include "planning/uniform.h"
#include "tests/support/planning_worlds.h"

namespace regista {
namespace {

std::vector<ObstacleIndex> passed_otherwise(const std::vector<Obstacle>& obstacles, const std::vector<Vec2>& before,
                                            const std::vector<Vec2>& now,
                                            const std::vector<std::size_t>& ignored = {}) {
  std::vector<ObstacleIndex> out;
  append_passed_otherwise(obstacles, ignored, before, now, out);
  return out;
}

/// Turns of the closed curve as seen from the point, from the sum of the angles.
long turns_by_angles(const std::vector<Vec2>& curve, const Vec2& point) {
  double sum_rad = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const Vec2 from = curve[i] - point;
    const Vec2 to = curve[(i + 1) % curve.size()] - point;
    sum_rad += std::atan2(cross(from, to), from.dot(to));
  }
  return std::lround(sum_rad / (2.0 * 3.14159265358979323846));
}

RobotPlan plan_along(const std::vector<Vec2>& path) {
  RobotPlan plan;
  plan.target.pose.position_m = {3, 0};
  plan.plan = {PlanStatus::ok, false, false, path, 0.0, ""};
  return plan;
}

}  // namespace

TEST_CASE("paths left and right of an obstacle differ about it and about no other") {
  const std::vector<Obstacle> obstacles{disc({0, 2}, 0.2), disc({0, 0}, 0.2), capsule({1, -0.1}, {1, 0.1}, 0.2),
                                        rounded_rectangle({-1, -3}, {1, -2}, 0.1)};
  const std::vector<Vec2> left{{-3, 0}, {0, 1}, {3, 0}};
  const std::vector<Vec2> right{{-2.95, 0.02}, {0, -1}, {3.02, 0.01}};
  CHECK(passed_otherwise(obstacles, left, right) == std::vector<ObstacleIndex>{1, 2});
  CHECK(passed_otherwise(obstacles, right, left) == std::vector<ObstacleIndex>{1, 2});
  CHECK(passed_otherwise(obstacles, left, right, {1}) == std::vector<ObstacleIndex>{2});
  const std::vector<Vec2> also_left{{-2.9, 0.03}, {-0.5, 0.5}, {0.5, 1.5}, {3, 0}};
  CHECK(passed_otherwise(obstacles, left, also_left).empty());
  CHECK(passed_otherwise(obstacles, left, left).empty());
  CHECK(passed_otherwise(obstacles, {{-3, 0}}, {{-3, 0}}).empty());
}

TEST_CASE("random pairs of paths: an obstacle is passed otherwise exactly when the angles add up to turns") {
  std::mt19937_64 random(31);
  const Bounds bounds = testing::test_bounds();
  int passed = 0;
  for (int pair = 0; pair < 3000; ++pair) {
    const auto path = [&] {
      std::vector<Vec2> points;
      for (std::uint64_t n = 1 + random() % 6; n > 0; --n) points.push_back(testing::random_point(random, bounds));
      return points;
    };
    const std::vector<Vec2> before = path();
    const std::vector<Vec2> now = path();
    std::vector<Vec2> curve = now;
    curve.insert(curve.end(), before.rbegin(), before.rend());
    const std::vector<Obstacle> obstacles{disc(testing::random_point(random, bounds), 0.2)};
    const bool turns = turns_by_angles(curve, obstacles[0].a) != 0;
    CAPTURE(pair);
    REQUIRE(passed_otherwise(obstacles, before, now).empty() != turns);
    passed += turns;
  }
  CHECK(passed > 300);
}

TEST_CASE("a change of side is counted between ok plans for the same target and nearly the same ends") {
  const ObstacleField field({{6, 4}}, {disc({0, 0}, 0.2)});
  const RobotPlan before = plan_along({{-3, 0}, {0, 1}, {3, 0}});
  const RobotPlan now = plan_along({{-2.97, 0}, {0, -1}, {3, 0}});
  CHECK(changes_side(field, {}, before, now));
  CHECK_FALSE(changes_side(field, {}, before, before));
  CHECK_FALSE(changes_side(field, std::vector<std::size_t>{0}, before, now));
  RobotPlan other = now;
  other.target.pose.position_m.x() += 1e-6;
  CHECK_FALSE(changes_side(field, {}, before, other));
  other = now;
  other.plan.status = PlanStatus::not_found;
  CHECK_FALSE(changes_side(field, {}, before, other));
  CHECK_FALSE(changes_side(field, {}, before, plan_along({{-2, 0}, {0, -1}, {3, 0}})));
  CHECK_FALSE(changes_side(field, {}, before, plan_along({})));
}

}  // namespace regista
