// The dynamic visibility graph and A* on it: every pair of corners is looked at, then the graph is searched, as
// published; a user says which edges are free.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "planning/planners/dvg_polygon.h"
#include "planning/request.h"

namespace regista::dvg {

enum class End { goal, no_way, no_time };

/// Which edge is asked for: edges at the start or the goal have their exceptions.
enum class Edge { between_corners, from_start, to_goal };

using IsFree = std::function<bool(const Vec2& from, const Vec2& to, Edge edge)>;

class Graph {
 public:
  /// Nodes are start, goal and the corners that `is_free` (asked with from = to). Edges are those that are free and,
  /// with `edge_limit`, not shorter than their objects' centres are apart; the limit does not concern start and goal.
  /// False when the time was up before all were looked at; it is asked for once per node.
  bool build(std::span<const Polygon> polygons, const Vec2& start, const Vec2& goal, bool edge_limit,
             const IsFree& is_free, const Budget& budget);

  /// A* over what has been built: the shortest path in it. True: it leads to the goal. False: there is none, and it
  /// leads to the node nearest to the goal among those that can be reached. The paper ends as soon as the goal is in
  /// the open list; here the goal has to come first in it, else the path need not be the shortest that the paper says
  /// it is.
  bool shortest_path(std::vector<Vec2>& path);

  std::size_t nodes() const { return nodes_.size(); }
  std::size_t edges() const { return edge_count_; }

 private:
  using Index = std::uint32_t;  ///< 0 is the start, 1 the goal

  struct Node {
    Vec2 position;
    Vec2 centre;  ///< of its object
    bool is_limited = false;
    double cost = 0.0;
    Index parent = 0;
    bool closed = false;
  };
  struct Link {
    Index to;
    double length_m;
  };
  struct Open {
    double estimate;
    Index node;
  };

  void add_node(const Vec2& position, const Vec2& centre, bool is_limited);
  void connect(Index one, Index other, const IsFree& is_free);
  void trace(Index last, std::vector<Vec2>& path) const;
  static bool later(const Open& a, const Open& b);

  std::vector<Node> nodes_;
  std::vector<std::vector<Link>> links_;  ///< may be longer than nodes_: memory of larger graphs
  std::vector<Open> open_;                ///< a heap
  std::size_t edge_count_ = 0;
};

}  // namespace regista::dvg
