#include "planning/side_keeping.h"

#include <limits>

#include "planning/path_sides.h"
#include "planning/polyline.h"

namespace regista {
namespace {

constexpr double kBarrierRadius_m = 1e-3;  ///< with none a barrier would forbid nothing
constexpr double kBeyondBounds_m = 0.01;   ///< where barriers end
/// A path that is kept from one side of a crowd may find the next gap in it; more often than that is never seen.
constexpr int kRounds = 3;

bool crosses(const Vec2& from, const Vec2& to, std::span<const Vec2> path) {
  // A barrier is clear of a path when a disc moved along each leg meets nothing of it.
  const Obstacle barrier = capsule(from, to, 2.0 * kBarrierRadius_m);
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!is_free(path[i - 1], path[i], barrier)) return true;
  }
  return false;
}

/// Where the ray leaves the bounds, which hold `from`, and a little farther.
Vec2 way_out(const Bounds& bounds, const Vec2& from, const Vec2& direction) {
  double length_m = std::numeric_limits<double>::infinity();
  for (const Eigen::Index axis : {0, 1}) {
    if (direction[axis] == 0.0) continue;
    const double border_m = std::copysign(bounds.half_extent_m[axis], direction[axis]);
    length_m = std::min(length_m, (border_m - from[axis]) / direction[axis]);
  }
  return from + (length_m + kBeyondBounds_m) * direction;
}

Vec2 nearest_point(std::span<const Vec2> path, const Vec2& point) {
  Vec2 nearest = path.front();
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec2 along = path[i] - path[i - 1];
    const double length2 = along.squaredNorm();
    const double share = length2 > 0.0 ? std::clamp((point - path[i - 1]).dot(along) / length2, 0.0, 1.0) : 0.0;
    const Vec2 foot = path[i - 1] + share * along;
    if ((foot - point).squaredNorm() < (nearest - point).squaredNorm()) nearest = foot;
  }
  return nearest;
}

/// Closes the side on which `now` passes the obstacle: from its middle through `now` and out of the bounds, where that
/// way does not meet `before`. The nearest point of `now` is tried first, then its vertices.
std::optional<Obstacle> barrier(const ObstacleField& field, ObstacleIndex obstacle, std::span<const Vec2> before,
                                std::span<const Vec2> now) {
  const Vec2 middle = middle_of(field.obstacles()[obstacle]);
  if (!is_inside(middle, field.bounds())) return std::nullopt;
  const auto through = [&](const Vec2& point) -> std::optional<Obstacle> {
    const double distance_m = (point - middle).norm();
    if (!(distance_m > kBarrierRadius_m)) return std::nullopt;
    const Vec2 end = way_out(field.bounds(), middle, (point - middle) / distance_m);
    if (crosses(middle, end, before)) return std::nullopt;
    return capsule(middle, end, kBarrierRadius_m);
  };
  if (auto found = through(nearest_point(now, middle))) return found;
  for (const Vec2& vertex : now) {
    if (auto found = through(vertex)) return found;
  }
  return std::nullopt;
}

}  // namespace

bool SideKeeper::close(const ObstacleField& field, std::span<const Vec2> before, std::span<const Vec2> now) {
  const std::size_t barriers = obstacles_.size();
  for (const ObstacleIndex obstacle : passed_otherwise_) {
    if (const auto closed = barrier(field, obstacle, before, now)) obstacles_.push_back(*closed);
  }
  return obstacles_.size() > barriers;
}

bool SideKeeper::search(Planner& planner, const ObstacleField& field, const PlanRequest& request, double longest_m,
                        Plan& found) {
  obstacles_.assign(field.obstacles().begin(), field.obstacles().end());
  Plan plan = found;
  PlanRequest bounded = request;
  bounded.length_max_m = longest_m;
  for (int round = 0; round < kRounds; ++round) {
    if (!close(field, request.previous_path, plan.path)) return false;
    graph_.reset(field.bounds(), obstacles_);
    planner.plan(graph_, bounded, plan);
    const bool same_ends = plan.start_moved == found.start_moved && plan.goal_moved == found.goal_moved &&
                           !plan.path.empty() && plan.path.back() == found.path.back();
    if (plan.status != PlanStatus::ok || !same_ends || plan.length_m > longest_m) return false;
    passed_otherwise_.clear();
    append_passed_otherwise(field.obstacles(), request.ignored, request.previous_path, plan.path, passed_otherwise_);
    if (passed_otherwise_.empty()) {
      found = std::move(plan);
      return true;
    }
  }
  return false;
}

void SideKeeper::keep(Planner& planner, const ObstacleField& field, const PlanRequest& request, double gain,
                      Plan& found) {
  if (found.status != PlanStatus::ok || !is_same_errand(request.previous_path, found.path)) return;
  passed_otherwise_.clear();
  append_passed_otherwise(field.obstacles(), request.ignored, request.previous_path, found.path, passed_otherwise_);
  if (passed_otherwise_.empty()) return;
  const double longest_m = (1.0 + gain) * found.length_m;
  if (search(planner, field, request, longest_m, found) || found.start_moved) return;
  // The followed path itself, where it is still free: for planners whose luck or time did not suffice.
  const Query query{
      request.start, found.path.back(), request.ignored, request.seed, request.budget, request.previous_path, {},
      false};
  const auto kept = kept_path(field, query, kEndsApart_m);
  if (!kept || length_of(*kept) > longest_m) return;
  found.path = *kept;
  found.length_m = length_of(found.path);
}

}  // namespace regista
