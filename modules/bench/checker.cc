#include "modules/bench/checker.h"

#include <fmt/core.h>

#include "planning/clearance.h"

namespace regista::bench {
namespace {

constexpr std::size_t kTextsMax = 5;

/// Rounding in the sum of a path's legs, per metre.
constexpr double kLengthRounding = 1e-9;

std::string text(const Vec2& v) { return fmt::format("({:.17g}, {:.17g})", v.x(), v.y()); }

/// The first leg of a moved start may cross what covers the start, and nothing else.
bool leg_is_free(const World& world, const PlanRequest& request, const Vec2& from, const Vec2& to, bool leaves_cover,
                 std::string& fault) {
  if (!is_inside(to, world.bounds) || (!leaves_cover && !is_inside(from, world.bounds))) {
    fault = fmt::format("leg {} {} is out of bounds", text(from), text(to));
    return false;
  }
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    const Obstacle& obstacle = world.obstacles[i];
    if (std::binary_search(request.ignored.begin(), request.ignored.end(), i)) continue;
    if (is_free(from, to, obstacle)) continue;
    if (leaves_cover && !is_free(from, obstacle)) continue;
    fault = fmt::format("leg {} {} is {:.3g} m inside obstacle {}", text(from), text(to),
                        -clearance(from, to, obstacle), i);
    return false;
  }
  return true;
}

}  // namespace

std::string fault_of(const World& world, const PlanRequest& request, const Plan& plan) {
  if (plan.status != PlanStatus::ok) return "";
  if (plan.path.empty()) return "ok without a path";
  if (plan.path.front() != request.start) return "does not begin at the start";
  if (!plan.goal_moved && plan.path.back() != request.goal) return "does not end at the goal";
  double length_m = 0.0;
  std::string fault;
  for (std::size_t i = 1; i < plan.path.size(); ++i) {
    const Vec2& from = plan.path[i - 1];
    const Vec2& to = plan.path[i];
    if (!is_finite(to)) return "is not finite";
    if (!leg_is_free(world, request, from, to, i == 1 && plan.start_moved, fault)) return fault;
    length_m += (to - from).norm();
  }
  if (!(std::abs(length_m - plan.length_m) <= kLengthRounding * (1.0 + length_m))) {
    return fmt::format("says {:.9g} m and is {:.9g} m long", plan.length_m, length_m);
  }
  return "";
}

bool Checker::check(const std::string& planner, const World& world, const PlanRequest& request, const Plan& plan) {
  if (plan.status != PlanStatus::ok) return true;
  ++checked_;
  const std::string fault = fault_of(world, request, plan);
  if (fault.empty()) return true;
  add_fault(planner, fmt::format("{}; start {}, goal {}, {} obstacles", fault, text(request.start), text(request.goal),
                                 world.obstacles.size()));
  return false;
}

void Checker::add_fault(const std::string& planner, const std::string& text) {
  ++faults_;
  ++by_planner_[planner];
  if (texts_.size() < kTextsMax) texts_.push_back(planner + ": " + text);
}

std::size_t Checker::faults(const std::string& planner) const {
  const auto found = by_planner_.find(planner);
  return found == by_planner_.end() ? 0 : found->second;
}

}  // namespace regista::bench
