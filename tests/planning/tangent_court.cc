#include "tests/planning/tangent_court.h"

#include <cmath>
#include <iostream>

#include "tests/support/planning_oracles.h"
#include "tests/support/tangent_oracle.h"
#include "tests/support/varied_worlds.h"

namespace regista::testing {
namespace {

constexpr double kRelative = 1e-6;
constexpr double kPolylineExcess = 1e-3;  // a circumscribed polyline may be so much longer than its arcs

std::string text(const std::optional<double>& length_m) {
  return length_m ? std::to_string(*length_m) + " m" : "no way";
}

}  // namespace

std::string Court::fault(const ObstacleField& field, const PlanRequest& request) {
  if (!point_is_free(field, request.start, request.ignored)) return "";
  if (!point_is_free(field, request.goal, request.ignored)) return "";
  expected_m_ = exact_shortest_length(field, request.start, request.goal, request.ignored);
  ++worlds_;
  if (!expected_m_) {
    ++unreachable_;
  } else if (*expected_m_ > (request.goal - request.start).norm() * (1.0 + kRelative)) {
    ++bent_;
  }
  graph_.reset(field);
  std::string wrong;
  if (request.start != request.goal) wrong = fault_of_search(request);
  if (wrong.empty()) wrong = fault_of_plan(request);
  if (wrong.empty()) return "";
  std::cerr << pasteable(field, request) << std::endl;
  return wrong + "; expected " + text(expected_m_) + ", found " + std::to_string(search_.length_m()) + " m";
}

std::string Court::fault(const ObstacleField& field, const Vec2& start, const Vec2& goal) {
  PlanRequest request;
  request.start = start;
  request.goal = goal;
  return fault(field, request);
}

std::string Court::fault_of_search(const PlanRequest& request) {
  using End = graph::TangentSearch::End;
  const Query query{request.start, request.goal, request.ignored, request.seed, request.budget, {}};
  const End end = search_.find(graph_, query, path_);
  if (end == End::no_time) return "the search stops for a time that nobody limited";
  if ((end == End::goal) != expected_m_.has_value()) return "the search is wrong about reachability";
  if (end != End::goal) return "";
  if (path_.front() != request.start || path_.back() != request.goal) return "the search's path has other ends";
  if (!(std::abs(search_.length_m() - *expected_m_) <= kRelative * *expected_m_)) return "not the exact length";
  if (!search_.is_path_known_free()) return "";
  ++known_free_;
  if (!graph_.field().is_free(path_, request.ignored)) return "the path that the search knows to be free is not";
  return "";
}

std::string Court::fault_of_plan(const PlanRequest& request) {
  const Plan plan = planner_->plan(graph_, request);
  if (plan.status != (expected_m_ ? PlanStatus::ok : PlanStatus::unreachable)) {
    return std::string("the plan is ") + name(plan.status) + ": " + plan.reason;
  }
  if (!expected_m_) return "";
  const std::string wrong = fault_of(graph_.field(), request, plan);
  if (!wrong.empty()) return "the plan " + wrong;
  if (!(plan.length_m >= *expected_m_ * (1.0 - kRelative))) return "the plan is shorter than the shortest path";
  if (!(plan.length_m <= *expected_m_ * (1.0 + kPolylineExcess))) return "the plan's polyline is too long";
  if (request.start == request.goal) return "";
  if (!(plan.length_m >= search_.length_m() - 1e-12)) return "the polyline is shorter than its arcs";
  return "";
}

}  // namespace regista::testing
