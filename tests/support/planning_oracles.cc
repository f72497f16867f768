#include "tests/support/planning_oracles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace regista::testing {
namespace {

/// The core's corners counter-clockwise.
std::vector<Vec2> corners_of(const Obstacle& obstacle) {
  const Vec2& a = obstacle.a;
  const Vec2& b = obstacle.b;
  if (obstacle.core == Core::point) return {a};
  if (obstacle.core == Core::segment) return {a, b};
  return {a, {b.x(), a.y()}, b, {a.x(), b.y()}};
}

bool is_within_core(const Vec2& point, const Obstacle& obstacle) {
  return obstacle.core == Core::rectangle && (point.array() >= obstacle.a.array()).all() &&
         (point.array() <= obstacle.b.array()).all();
}

double core_distance(const Vec2& point, const Obstacle& obstacle) {
  if (is_within_core(point, obstacle)) return 0.0;
  const std::vector<Vec2> corners = corners_of(obstacle);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 nearest = nearest_on_segment(point, corners[i], corners[(i + 1) % corners.size()]);
    least = std::min(least, (point - nearest).norm());
  }
  return least;
}

}  // namespace

std::vector<Vec2> boundary_points(const Obstacle& obstacle, double step_m) {
  std::vector<Vec2> points;
  const std::vector<Vec2> corners = corners_of(obstacle);
  const auto keep = [&](const Vec2& point) {
    // Whole circles are walked around each corner; what is inside is no boundary.
    if (core_distance(point, obstacle) >= obstacle.radius_m - 1e-12) points.push_back(point);
  };
  const int around = 8 + static_cast<int>(2.0 * std::numbers::pi * obstacle.radius_m / step_m);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (int k = 0; k < around; ++k) {
      keep(corners[i] + rotated({obstacle.radius_m, 0.0}, 2.0 * std::numbers::pi * k / around));
    }
    const Vec2 along = corners[(i + 1) % corners.size()] - corners[i];
    const double length_m = along.norm();
    if (length_m == 0.0) continue;
    const Vec2 outwards = Vec2(along.y(), -along.x()) * (obstacle.radius_m / length_m);
    const int steps = 2 + static_cast<int>(length_m / step_m);
    for (int k = 0; k <= steps; ++k) keep(corners[i] + along * k / steps + outwards);
  }
  return points;
}

double sampled_clearance(const Vec2& point, const Obstacle& obstacle, double step_m) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2& boundary : boundary_points(obstacle, step_m)) least = std::min(least, (boundary - point).norm());
  const bool inside = core_distance(point, obstacle) < obstacle.radius_m || is_within_core(point, obstacle);
  return inside ? -least : least;
}

bool point_is_free(const ObstacleField& field, const Vec2& point, std::span<const std::size_t> ignored) {
  return segment_is_free(field, point, point, ignored);
}

bool segment_is_free(const ObstacleField& field, const Vec2& from, const Vec2& to,
                     std::span<const std::size_t> ignored) {
  for (const Vec2& end : {from, to}) {
    if (((end.cwiseAbs() - field.bounds().half_extent_m).array() > kTouch_m).any()) return false;
  }
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (std::find(ignored.begin(), ignored.end(), i) != ignored.end()) continue;
    if (clearance(from, to, field.obstacles()[i]) < -kTouch_m) return false;
  }
  return true;
}

std::string fault_of(const ObstacleField& field, const PlanRequest& request, const Plan& plan) {
  if (plan.path.empty() || plan.path.front() != request.start) return "does not begin at the start";
  if (!plan.goal_moved && plan.path.back() != request.goal) return "does not end at the goal";
  if (plan.goal_moved && point_is_free(field, request.goal, request.ignored)) return "moves a free goal";
  if (plan.start_moved == point_is_free(field, request.start, request.ignored)) return "start_moved is wrong";
  if (!plan.reason.empty()) return "is ok but has the reason: " + plan.reason;
  std::vector<std::size_t> covering = request.ignored;
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (clearance(request.start, field.obstacles()[i]) < -kTouch_m) covering.push_back(i);
  }
  double length_m = 0.0;
  for (std::size_t i = 1; i < plan.path.size(); ++i) {
    const bool way_out = plan.start_moved && i == 1;
    const Vec2& from = way_out ? plan.path[1] : plan.path[i - 1];
    if (way_out) {
      const ObstacleField unbounded(Bounds{Vec2::Constant(1e6)}, {field.obstacles().begin(), field.obstacles().end()});
      if (!segment_is_free(unbounded, plan.path[0], plan.path[1], covering)) return "way out crosses another obstacle";
    }
    if (!segment_is_free(field, from, plan.path[i], request.ignored)) return "leads through an obstacle";
    length_m += (plan.path[i] - plan.path[i - 1]).norm();
  }
  if (std::abs(length_m - plan.length_m) > 1e-9) return "states a wrong length";
  return "";
}

std::optional<double> shortest_length(const ObstacleField& field, const std::vector<Vec2>& nodes,
                                      std::span<const std::size_t> ignored) {
  std::vector<double> cost(nodes.size(), std::numeric_limits<double>::infinity());
  std::vector<bool> closed(nodes.size(), false);
  cost[0] = 0.0;
  for (;;) {
    std::size_t node = nodes.size();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!closed[i] && std::isfinite(cost[i]) && (node == nodes.size() || cost[i] < cost[node])) node = i;
    }
    if (node == nodes.size()) return std::nullopt;
    if (node == 1) return cost[1];
    closed[node] = true;
    for (std::size_t next = 0; next < nodes.size(); ++next) {
      const double through = cost[node] + (nodes[next] - nodes[node]).norm();
      if (through >= cost[next] || !segment_is_free(field, nodes[node], nodes[next], ignored)) continue;
      cost[next] = through;
    }
  }
}

}  // namespace regista::testing
