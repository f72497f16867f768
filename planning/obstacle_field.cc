#include "planning/obstacle_field.h"

#include <stdexcept>
#include <string>

namespace regista {
namespace {

std::string text(const Vec2& v) { return "(" + std::to_string(v.x()) + ", " + std::to_string(v.y()) + ")"; }

/// At the cost of a few sums: none of them can hide a number that is too large, or none.
bool are_surely_valid(std::span<const Obstacle> obstacles) {
  Vec2 even = Vec2::Zero();
  Vec2 odd = Vec2::Zero();  // a sum has to wait for the one before
  unsigned is_negative = 0;
  const auto add = [&](Vec2& sum, const Obstacle& obstacle) {
    sum += obstacle.a.cwiseAbs() + obstacle.b.cwiseAbs() + Vec2::Constant(obstacle.radius_m);
    is_negative |= static_cast<unsigned>(!(obstacle.radius_m >= 0.0));
  };
  std::size_t i = 0;
  for (; i + 1 < obstacles.size(); i += 2) {
    add(even, obstacles[i]);
    add(odd, obstacles[i + 1]);
  }
  if (i < obstacles.size()) add(even, obstacles[i]);
  return (even + odd).sum() <= kLargest_m && is_negative == 0;
}

void check(const Bounds& bounds, std::span<const Obstacle> obstacles) {
  if (!is_finite(bounds.half_extent_m) || bounds.half_extent_m.minCoeff() < 0.0) {
    throw std::invalid_argument("bounds must be finite and not negative, not " + text(bounds.half_extent_m) + " m");
  }
  if (are_surely_valid(obstacles)) return;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const Obstacle& obstacle = obstacles[i];
    if (is_valid(obstacle)) continue;
    throw std::invalid_argument("obstacle " + std::to_string(i) + " must be within " + std::to_string(kLargest_m) +
                                " m with a radius >= 0, not " + text(obstacle.a) + " " + text(obstacle.b) + " radius " +
                                std::to_string(obstacle.radius_m) + " m");
  }
}

}  // namespace

Obstacle capsule_around(const Obstacle& obstacle) {
  if (obstacle.core != Core::rectangle) return capsule(obstacle.a, obstacle.b, obstacle.radius_m);
  const Vec2 half = 0.5 * (obstacle.b - obstacle.a);
  const Vec2 middle = 0.5 * (obstacle.a + obstacle.b);
  const Vec2 along = half.x() >= half.y() ? Vec2(half.x(), 0.0) : Vec2(0.0, half.y());
  return capsule(middle - along, middle + along, obstacle.radius_m + half.minCoeff());
}

ObstacleField::ObstacleField(const Bounds& bounds, std::vector<Obstacle> obstacles)
    : bounds_(bounds), obstacles_(std::move(obstacles)) {
  check(bounds_, obstacles_);
  boxes_.assign(obstacles_);
}

void ObstacleField::assign(const Bounds& bounds, std::span<const Obstacle> obstacles) {
  check(bounds, obstacles);
  bounds_ = bounds;
  obstacles_.assign(obstacles.begin(), obstacles.end());
  boxes_.assign(obstacles_);
}

std::optional<ObstacleIndex> ObstacleField::first_blocker(const Vec2& from, const Vec2& to,
                                                          std::span<const std::size_t> ignored) const {
  std::optional<ObstacleIndex> found;
  boxes_.visit_near(from, to, 0.0, [&](ObstacleIndex i) {
    if (is_ignored(i, ignored) || regista::is_free(from, to, obstacles_[i])) return false;
    found = i;
    return true;
  });
  return found;
}

bool ObstacleField::is_free(std::span<const Vec2> path, std::span<const std::size_t> ignored) const {
  // Short legs, as an arc has them, are asked for together.
  constexpr double kShortRun_m = 0.5;
  for (const Vec2& point : path) {
    if (!is_inside(point, bounds_)) return false;
  }
  for (std::size_t begin = 0; begin + 1 < path.size();) {
    std::size_t end = begin + 1;
    double length_m = (path[end] - path[begin]).norm();
    while (end + 1 < path.size()) {
      const double longer_m = length_m + (path[end + 1] - path[end]).norm();
      if (longer_m > kShortRun_m) break;
      length_m = longer_m;
      ++end;
    }
    if (!is_run_free(path.subspan(begin, end - begin + 1), length_m, ignored)) return false;
    begin = end;
  }
  return true;
}

/// No point of a run is farther from its chord than half of √(length² - chord²), the lesser axis of the ellipse of all
/// points on ways of that length.
bool ObstacleField::is_run_free(std::span<const Vec2> run, double length_m,
                                std::span<const std::size_t> ignored) const {
  const double chord2 = (run.back() - run.front()).squaredNorm();
  const double bulge_m = run.size() == 2 ? 0.0 : 0.5 * std::sqrt(std::max(length_m * length_m - chord2, 0.0));
  bool is_blocked = false;
  boxes_.visit_near(run.front(), run.back(), bulge_m, [&](ObstacleIndex i) {
    if (is_ignored(i, ignored)) return false;
    for (std::size_t k = 1; k < run.size() && !is_blocked; ++k) {
      is_blocked = !regista::is_free(run[k - 1], run[k], obstacles_[i]);
    }
    return is_blocked;
  });
  return !is_blocked;
}

void ObstacleField::blockers(const Vec2& from, const Vec2& to, std::vector<ObstacleIndex>& out) const {
  boxes_.visit_near(from, to, 0.0, [&](ObstacleIndex i) {
    if (!regista::is_free(from, to, obstacles_[i])) out.push_back(i);
    return false;
  });
}

}  // namespace regista
