// What every planner is: one function from a field of obstacles and a request to a plan. Callers see `plan`, which
// checks what goes in and what comes out; a new planner writes `search` and is named in registry.cc.
#pragma once

#include "planning/goal_adjustment.h"
#include "planning/graph/shared_graph.h"
#include "planning/plan.h"
#include "planning/request.h"

namespace regista {

/// What a search found. path: from the query's start to its goal when ok; else from the start to the reachable point
/// nearest to the goal that is known, or empty.
struct SearchResult {
  PlanStatus status = PlanStatus::not_found;
  std::vector<Vec2> path;
  std::string reason;
  /// By the way it was found the whole path is free by clearance.h, so it is not tested again.
  bool is_known_free = false;
};

/// Laws, checked here and by the conformance test:
/// - the answer is a function of field and request alone: not of earlier queries, of other robots, or of what the graph
///   already knows; a planner keeps only scratch memory between queries;
/// - ok: the path begins at the start, ends at the goal, and every leg is inside the bounds and free by clearance.h of
///   all obstacles not ignored. An answer that fails this is turned into not_found, never passed on. Where a search
///   has tested all of its path itself, it is not tested again;
/// - a covered start (an obstacle or the outside covers it) is left by the shortest straight way out whose leg crosses
///   only what covers the start; start_moved says so and the path still begins at the start itself;
/// - a covered goal is moved to the nearest free point; goal_moved says so;
/// - start = goal: ok with a path of that one point;
/// - unreachable is a proof: no free point near start or goal, or the search proved it.
class Planner {
 public:
  Planner() = default;
  Planner(const Planner&) = delete;
  Planner& operator=(const Planner&) = delete;
  virtual ~Planner() = default;

  /// Throws std::invalid_argument, with the value in the text, when a coordinate is not finite, the budget negative, or
  /// `ignored` not sorted or out of range.
  Plan plan(graph::SharedGraph& graph, const PlanRequest& request);

  /// The same on a graph of its own.
  Plan plan(const ObstacleField& field, const PlanRequest& request);

  /// The same into an answer whose memory is reused.
  void plan(graph::SharedGraph& graph, const PlanRequest& request, Plan& answer);

 protected:
  /// Start and goal of the query are free and differ; the field is graph.field(). `result` arrives as default apart
  /// from memory to reuse.
  virtual void search(graph::SharedGraph& graph, const Query& query, SearchResult& result) = 0;

 private:
  void find_blockers(const ObstacleField& field, const Vec2& from, const Vec2& to,
                     std::span<const std::size_t> ignored);

  GoalAdjustment adjustment_;  ///< scratch, as all of these
  std::vector<ObstacleIndex> blockers_;
  SearchResult result_;
};

/// plan(), but a request that makes no sense is answered by status invalid and the reason instead of a throw.
Plan plan_or_invalid(Planner& planner, graph::SharedGraph& graph, const PlanRequest& request);

/// Sum of the legs, metres; 0 for fewer than two points.
double length_of(std::span<const Vec2> path);

}  // namespace regista
