#include "planning/planner.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace regista {
namespace {

std::string text(const Vec2& v) { return "(" + std::to_string(v.x()) + ", " + std::to_string(v.y()) + ") m"; }

bool is_usable(const Vec2& point) { return point.cwiseAbs().maxCoeff() <= kLargest_m && is_finite(point); }

void check(const PlanRequest& request, std::size_t obstacles) {
  if (!is_usable(request.start))
    throw std::invalid_argument("start must be finite, below 1e9, not " + text(request.start));
  if (!is_usable(request.goal))
    throw std::invalid_argument("goal must be finite, below 1e9, not " + text(request.goal));
  if (request.budget.iterations < 0) {
    throw std::invalid_argument("iterations must be >= 0, not " + std::to_string(request.budget.iterations));
  }
  for (const Vec2& point : request.previous_path) {
    if (!is_finite(point)) throw std::invalid_argument("the previous path must be finite, not " + text(point));
  }
  for (std::size_t i = 0; i < request.ignored.size(); ++i) {
    const std::size_t ignored = request.ignored[i];
    if (ignored >= obstacles) {
      throw std::invalid_argument("ignored obstacle " + std::to_string(ignored) + " does not exist, there are " +
                                  std::to_string(obstacles));
    }
    if (i > 0 && request.ignored[i - 1] >= ignored) {
      throw std::invalid_argument("ignored obstacles must be sorted, each once; " + std::to_string(ignored) +
                                  " comes after " + std::to_string(request.ignored[i - 1]));
    }
  }
}

/// What is wrong with a search's answer; empty when it keeps the laws. A path that did not get to the goal is held to
/// the same laws but for its end. Where one of its points is not finite, neither is its length.
std::string fault(const ObstacleField& field, const Query& query, const SearchResult& result, double length_m) {
  const bool ok = result.status == PlanStatus::ok;
  if (!ok && result.path.empty()) return "";
  if (ok && result.path.size() < 2) return "has no leg";
  if (result.path.front() != query.start) return "does not begin at the start";
  if (ok && result.path.back() != query.goal) return "does not end at the goal";
  if (!std::isfinite(length_m)) return "is not finite";
  if (query.is_straight_free && result.path.size() == 2 && ok) return "";
  if (!result.is_known_free && !field.is_free(result.path, query.ignored))
    return "leads through an obstacle or out of bounds";
  return "";
}

void refuse(Plan& answer, PlanStatus status, const char* reason) {
  answer.status = status;
  answer.reason = reason;
}

}  // namespace

void Planner::find_blockers(const ObstacleField& field, const Vec2& from, const Vec2& to,
                            std::span<const std::size_t> ignored) {
  blockers_.clear();
  field.blockers(from, to, blockers_);
  if (!ignored.empty()) std::erase_if(blockers_, [&](ObstacleIndex i) { return is_ignored(i, ignored); });
}

void Planner::plan(graph::SharedGraph& graph, const PlanRequest& request, Plan& answer) {
  const ObstacleField& field = graph.field();
  check(request, field.size());
  answer.path.clear();
  answer.reason.clear();
  answer.length_m = 0.0;
  answer.start_moved = answer.goal_moved = false;
  find_blockers(field, request.start, request.goal, request.ignored);
  // What covers an end blocks the line as well.
  const auto is_free_end = [&](const Vec2& end) {
    return is_inside(end, field.bounds()) && std::all_of(blockers_.begin(), blockers_.end(), [&](ObstacleIndex i) {
             return is_free(end, field.obstacles()[i]);
           });
  };
  const std::optional<Vec2> start =
      is_free_end(request.start) ? request.start : adjustment_.way_out(field, request.start, request.ignored);
  if (!start) return refuse(answer, PlanStatus::unreachable, "the start is covered and there is no straight way out");
  const std::optional<Vec2> goal =
      is_free_end(request.goal) ? request.goal : adjustment_.nearest_free_point(field, request.goal, request.ignored);
  if (!goal) return refuse(answer, PlanStatus::unreachable, "there is no free point for the goal");
  answer.start_moved = *start != request.start;
  answer.goal_moved = *goal != request.goal;
  if (answer.start_moved || answer.goal_moved) find_blockers(field, *start, *goal, request.ignored);

  const Query query{*start,
                    *goal,
                    request.ignored,
                    request.seed,
                    request.budget,
                    request.previous_path,
                    blockers_,
                    blockers_.empty(),
                    request.length_max_m};
  result_.status = PlanStatus::not_found;
  result_.path.clear();
  result_.reason.clear();
  result_.is_known_free = false;
  double length_m = 0.0;
  if (query.start == query.goal) {
    result_.status = PlanStatus::ok;
    result_.path.push_back(query.start);
  } else {
    search(graph, query, result_);
    length_m = length_of(result_.path);
    if (const std::string wrong = fault(field, query, result_, length_m); !wrong.empty()) {
      result_ = {PlanStatus::not_found, {}, "refused: the planner's path " + wrong};
      length_m = 0.0;
    }
  }
  answer.status = result_.status;
  answer.reason = result_.reason;
  const bool has_way_out = answer.start_moved && !result_.path.empty();
  if (has_way_out) answer.path.push_back(request.start);
  answer.path.insert(answer.path.end(), result_.path.begin(), result_.path.end());
  answer.length_m = has_way_out ? length_of(answer.path) : length_m;
}

Plan Planner::plan(graph::SharedGraph& graph, const PlanRequest& request) {
  Plan answer;
  plan(graph, request, answer);
  return answer;
}

Plan Planner::plan(const ObstacleField& field, const PlanRequest& request) {
  graph::SharedGraph graph(field);
  return plan(graph, request);
}

Plan plan_or_invalid(Planner& planner, graph::SharedGraph& graph, const PlanRequest& request) {
  try {
    return planner.plan(graph, request);
  } catch (const std::invalid_argument& error) {
    Plan answer;
    answer.status = PlanStatus::invalid;
    answer.reason = error.what();
    return answer;
  }
}

double length_of(std::span<const Vec2> path) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) length_m += (path[i] - path[i - 1]).norm();
  return length_m;
}

}  // namespace regista
