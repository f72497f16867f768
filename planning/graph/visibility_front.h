// One search for the shortest path over samples: lazy A* from one end, a few edges at a time. After "A Mapping &
// Planning Algorithm for RoboCup Small Size League" (BuildGraph), turned inside out: an obstacle is sampled when it
// blocks an edge that the search is about to use.
#pragma once

#include <limits>

#include "planning/graph/blocker_set.h"
#include "planning/graph/detours.h"
#include "planning/graph/search_queue.h"
#include "planning/graph/shared_graph.h"
#include "planning/request.h"

namespace regista::graph {

/// Nodes are the query's start and goal and the free samples of marked obstacles. Edges wait in a queue with an
/// optimistic cost. One that comes first and is blocked by no marked obstacle marks the one it crosses deepest, whose
/// samples become nodes; a covered sample that comes first does the same with what covers it (the paper's recursion).
/// An edge that reaches the goal ends the search, so the path is the shortest over all free samples of the obstacles
/// marked by then. The answer depends on field and query alone. Only scratch memory is kept between two searches.
class VisibilityFront {
 public:
  enum class Progress { going_on, goal, no_samples, no_time };

  /// Begins at the query's start.
  void begin(SharedGraph& graph, const Query& query);

  /// Looks at so many more edges, unless it ends before. no_samples: there is no way over the samples of the field. The
  /// time is asked for once in 64 edges, and before more of them are made.
  Progress advance(SharedGraph& graph, int edges);

  /// After goal: from the start to it. Else to the node nearest to the goal among those reached, which may be the start
  /// alone.
  void trace(std::vector<Vec2>& path) const;

  /// Obstacles the search sampled, in the order in which it marked them.
  std::span<const ObstacleIndex> marked() const { return marked_.list(); }

 private:
  using Local = std::uint32_t;  ///< index into nodes_

  static constexpr Local kStart = 0;
  static constexpr Local kGoal = 1;
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  /// Edges whose way is longer wait outside of the queue: at first by that share and length more than the straight
  /// line, later by that share more than what is needed.
  static constexpr double kDetour = 1.15;
  static constexpr double kDetour_m = 0.1;

  struct Node {
    Vec2 position;
    double cost;       ///< least known from the start
    double to_goal_m;  ///< straight
    double least_m;    ///< no way to the goal is shorter
    Local parent;
    NodeId shared;             ///< in the shared graph; of no meaning for start and goal
    ObstacleIndex covered_by;  ///< no node at all, but a reason to mark that obstacle; else kBounds
    std::uint32_t bound_by;    ///< how many of the marked obstacles the least way takes into account
    bool is_expanded;
  };
  struct Edge {
    double cost;  ///< from the start to its end
    Local from;
    Local to;
    std::uint32_t free_of;  ///< how many of the marked obstacles it was tested against
  };

  void add_node(const Vec2& position, NodeId shared, ObstacleIndex covered_by);
  void add_samples(SharedGraph& graph, ObstacleIndex obstacle);
  void expand(Local node);
  void queue_edge(Local from, Local to, double done_m);
  void queue_edges_to(std::size_t first_target);
  void drop_void_targets();
  bool widen();
  bool is_void(const Node& node) const { return node.covered_by != kBounds && marked_.contains(node.covered_by); }
  bool is_free_of_marked(const ObstacleBoxes::Motion& motion);
  double least_to_goal_m(Node& node);
  const Edge* next_edge();
  bool is_open(SharedGraph& graph, const Edge& edge);
  void mark(SharedGraph& graph, ObstacleIndex obstacle);
  bool mark_rest(SharedGraph& graph);
  bool is_near_expanded(const Obstacle& obstacle) const;

  /// The one that the segment crosses deepest among those that are obstacles to this robot; kBounds when one of them is
  /// marked already, or none is left.
  ObstacleIndex worth_marking(const Vec2& from, const Vec2& to, std::span<const ObstacleIndex> blockers) const;
  bool blocks_one(std::span<const ObstacleIndex> obstacles) const;

  Query query_;  ///< of the search that runs
  const ObstacleField* field_ = nullptr;
  std::vector<Node> nodes_;
  std::vector<Local> targets_;  ///< nodes that edges may lead to
  std::vector<Local> expanded_;
  std::vector<Edge> edges_;  ///< all that were queued
  SearchQueue queue_;
  BlockerSet marked_;
  Detours detours_;                      ///< as many of the marked ones as were asked for
  Occluders occluders_;                  ///< of edges that were looked at lately
  std::vector<ObstacleIndex> blockers_;  ///< scratch
  double limit_m_ = 0.0;                 ///< edges of a larger estimate wait outside of the queue
  double least_beyond_m_ = 0.0;          ///< the least estimate of these
  int edges_tested_ = 0;
  double rest_within_m_ = 0.0;          ///< of what was reached, when nothing that blocked anything helps
  std::size_t targets_checked_at_ = 0;  ///< so many marked obstacles
  Local last_ = 0;                      ///< the goal, or the node nearest to it among those reached
};

}  // namespace regista::graph
