#include "planning/path_sides.h"

#include <limits>

namespace regista {
namespace {

/// What an edge from `from` to `to` adds to the number of times a closed curve winds around the point: it counts where
/// it passes to the point's right, upwards or downwards (Sunday, "Inclusion of a Point in a Polygon").
int winding(const Vec2& from, const Vec2& to, const Vec2& point) {
  const bool from_below = from.y() <= point.y();
  const bool to_below = to.y() <= point.y();
  if (from_below == to_below) return 0;
  const double left = cross(to - from, point - from);
  if (from_below) return left > 0.0 ? 1 : 0;
  return left < 0.0 ? -1 : 0;
}

int winding(std::span<const Vec2> path, const Vec2& point) {
  int sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += winding(path[i - 1], path[i], point);
  return sum;
}

struct Box {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;
  void add(std::span<const Vec2> points) {
    for (const Vec2& point : points) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  }
  bool holds(const Vec2& point) const {
    return low.x() <= point.x() && point.x() <= high.x() && low.y() <= point.y() && point.y() <= high.y();
  }
};

}  // namespace

void append_passed_otherwise(std::span<const Obstacle> obstacles, std::span<const std::size_t> ignored,
                             std::span<const Vec2> before, std::span<const Vec2> now, std::vector<ObstacleIndex>& out) {
  Box box;
  box.add(before);
  box.add(now);
  for (ObstacleIndex i = 0; i < obstacles.size(); ++i) {
    const Vec2 middle = middle_of(obstacles[i]);
    if (!box.holds(middle) || is_ignored(i, ignored)) continue;
    const int turns = winding(now, middle) + winding(now.back(), before.back(), middle) - winding(before, middle) +
                      winding(before.front(), now.front(), middle);
    if (turns != 0) out.push_back(i);
  }
}

bool is_same_errand(std::span<const Vec2> before, std::span<const Vec2> now) {
  return !before.empty() && !now.empty() && (before.front() - now.front()).norm() <= kEndsApart_m &&
         (before.back() - now.back()).norm() <= kEndsApart_m;
}

bool changes_side(const ObstacleField& field, std::span<const std::size_t> ignored, const RobotPlan& before,
                  const RobotPlan& now) {
  if (before.plan.status != PlanStatus::ok || now.plan.status != PlanStatus::ok) return false;
  if (!(before.target == now.target) || !is_same_errand(before.plan.path, now.plan.path)) return false;
  std::vector<ObstacleIndex> passed_otherwise;
  append_passed_otherwise(field.obstacles(), ignored, before.plan.path, now.plan.path, passed_otherwise);
  return !passed_otherwise.empty();
}

}  // namespace regista
