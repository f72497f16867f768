#include "tests/support/planning_worlds.h"

#include "planning/uniform.h"

namespace regista::testing {
namespace {

constexpr double kRobotReach_m = 0.21;  // two robots' radii and a margin

}  // namespace

Bounds test_bounds() { return {{kHalfLength_m, kHalfWidth_m}}; }

Vec2 random_point(std::mt19937_64& random, const Bounds& bounds) {
  const double x = uniform(random, -1.0, 1.0) * bounds.half_extent_m.x();
  const double y = uniform(random, -1.0, 1.0) * bounds.half_extent_m.y();
  return {x, y};
}

Obstacle random_obstacle(std::mt19937_64& random, const Bounds& bounds) {
  const double kind = uniform(random);
  const Vec2 a = random_point(random, bounds);
  if (kind < 0.7) return disc(a, kRobotReach_m);
  const double x = uniform(random, -1.5, 1.5);
  const double y = uniform(random, -1.5, 1.5);
  const double radius_m = uniform(random, 0.0, 0.5);
  return kind < 0.85 ? capsule(a, a + Vec2(x, y), radius_m) : rounded_rectangle(a, a + Vec2(x, y), radius_m);
}

ObstacleField random_field(std::mt19937_64& random, std::size_t obstacles) {
  std::vector<Obstacle> all;
  for (std::size_t i = 0; i < obstacles; ++i) all.push_back(random_obstacle(random, test_bounds()));
  return {test_bounds(), all};
}

PlanRequest random_request(std::mt19937_64& random, const ObstacleField& field) {
  PlanRequest request;
  request.start = random_point(random, field.bounds());
  request.goal = random_point(random, field.bounds());
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (uniform(random) < 0.05) request.ignored.push_back(i);
  }
  request.seed = random();
  return request;
}

PlanRequest random_free_request(std::mt19937_64& random, const ObstacleField& field) {
  constexpr int kTries = 1000;
  PlanRequest request = random_request(random, field);
  for (int i = 0; i < kTries && !field.is_free(request.start, request.ignored); ++i) {
    request.start = random_point(random, field.bounds());
  }
  for (int i = 0; i < kTries && !field.is_free(request.goal, request.ignored); ++i) {
    request.goal = random_point(random, field.bounds());
  }
  return request;
}

Obstacle mirrored(const Obstacle& obstacle, const Vec2& signs) {
  const Vec2 a = obstacle.a.cwiseProduct(signs);
  const Vec2 b = obstacle.b.cwiseProduct(signs);
  if (obstacle.core == Core::rectangle) return rounded_rectangle(a, b, obstacle.radius_m);
  return {obstacle.core, a, b, obstacle.radius_m};
}

ObstacleField mirrored(const ObstacleField& field, const Vec2& signs) {
  std::vector<Obstacle> all;
  for (const Obstacle& obstacle : field.obstacles()) all.push_back(mirrored(obstacle, signs));
  return {field.bounds(), all};
}

PlanRequest mirrored(PlanRequest request, const Vec2& signs) {
  request.start = request.start.cwiseProduct(signs);
  request.goal = request.goal.cwiseProduct(signs);
  for (Vec2& point : request.previous_path) point = point.cwiseProduct(signs);
  return request;
}

std::vector<Obstacle> ring_around(const Vec2& centre, double radius_m) {
  constexpr int kPerSide = 8;
  std::vector<Obstacle> ring;
  for (int k = 0; k < kPerSide; ++k) {
    const double along = radius_m * (2.0 * k / kPerSide - 1.0);
    for (const Vec2& offset :
         {Vec2(along, -radius_m), Vec2(radius_m, along), Vec2(-along, radius_m), Vec2(-radius_m, -along)}) {
      ring.push_back(disc(centre + offset, 0.15 * radius_m));
    }
  }
  return ring;
}

}  // namespace regista::testing
