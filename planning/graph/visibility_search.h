// The shortest path over the samples of the obstacles that stand in the way, and of no others: lazy A* on the shared
// graph. After "A Mapping & Planning Algorithm for RoboCup Small Size League" (BuildGraph), turned inside out: an
// obstacle is sampled when it blocks an edge that the search is about to use.
#pragma once

#include "planning/graph/shared_graph.h"
#include "planning/plan.h"
#include "planning/request.h"

namespace regista::graph {

/// Nodes are the query's start and goal and the free samples of marked obstacles. Edges wait in a queue with an
/// optimistic cost and are tested only when they come first; a blocked one marks its blockers, whose samples become
/// nodes; a sample that turns out to be covered marks what covers it (the paper's recursion). An edge that reaches the
/// goal ends the search, so the path is the shortest over all free samples of the obstacles marked by then.
/// The answer depends on field and query alone. Only scratch memory is kept between two searches.
class VisibilitySearch {
 public:
  enum class End { goal, no_samples, no_time };

  /// Why the search ended. goal: `path` leads from the start to it. Else the samples or the time gave out, and the path
  /// leads to the node nearest to the goal among those reached, and may be the start alone. The time is asked for once
  /// in 64 edges.
  End find(SharedGraph& graph, const Query& query, std::vector<Vec2>& path);

  /// Obstacles the last search sampled, in the order in which it marked them.
  std::span<const ObstacleIndex> marked() const { return marked_; }

 private:
  using Local = std::uint32_t;  ///< index into nodes_; 0 is the start, 1 the goal

  struct Node {
    Vec2 position;
    double cost = 0.0;       ///< least known from the start
    double heuristic = 0.0;  ///< straight line to the goal
    Local parent = 0;
    NodeId shared = 0;  ///< in the shared graph; of no meaning for start and goal
    bool covering_checked = false;
    bool covered = false;  ///< no node at all
    bool expanded = false;
  };
  struct Edge {
    double estimate;   ///< cost at from + length + heuristic at to
    double from_cost;  ///< cost at from when the edge was queued; a lower one since then has queued it anew
    Local from;
    Local to;
  };

  void clear(const SharedGraph& graph, const Query& query);
  void add_node(const Vec2& position, NodeId shared);
  void queue_edge(Local from, Local to);
  void expand(Local node);
  bool next_edge(Edge& edge);
  bool is_covered(SharedGraph& graph, Local node);
  bool is_open(SharedGraph& graph, const Edge& edge);
  void mark(SharedGraph& graph, std::span<const ObstacleIndex> obstacles);
  bool mark_rest(SharedGraph& graph);
  void trace(Local last, std::vector<Vec2>& path) const;

  /// Heap order: the edge with the larger estimate comes later; ties go by node, so that the order is total.
  static bool later(const Edge& a, const Edge& b);

  std::span<const std::size_t> ignored_;  ///< of the query that runs
  Vec2 goal_ = Vec2::Zero();              ///< of the query that runs
  std::vector<Node> nodes_;
  std::vector<Local> expanded_;
  std::vector<Edge> queue_;  ///< a heap, least estimate first
  std::vector<ObstacleIndex> marked_;
  std::vector<std::uint8_t> is_marked_;
  std::vector<ObstacleIndex> blockers_;  ///< scratch
};

}  // namespace regista::graph
