// A* over the centres of square cells, eight neighbours: what Costa & Tonidandel decide against ("a 240 × 180 map", 3)
// and the "A*" of the iterative RRT paper's table I, of which neither says that its path was smoothed; this one is not.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "planning/planner.h"
#include "planning/planners/cell_grid.h"
#include "planning/planning_params.h"

namespace regista {

/// Legs are free by the field's exact test; what is farther from all obstacles than a leg is long needs none. Start and
/// goal are joined to the nearest centres that they see: those of the four cells around, else of the sixteen, and so on
/// up to 8 × 8. A way narrower than a cell may be missed, so no path is no proof. Of the path only the points where it
/// turns are given.
/// Runs in a frame in which the goal lies ahead and to the left, so that mirrored worlds have mirrored paths in spite
/// of the many ways of one length that a grid has.
class AstarGrid : public Planner {
 public:
  explicit AstarGrid(const PlanningParams& params = {}) : AstarGrid(params.astar_grid) {}
  explicit AstarGrid(const AstarGridParams& params) : grid_(params.cell_m) {}

 protected:
  void search(graph::SharedGraph& graph, const Query& query, SearchResult& result) override;

 private:
  enum class End { goal, no_way, no_time };
  using Cell = CellGrid::Cell;
  using Index = CellGrid::Index;
  using Kind = CellGrid::Kind;
  using Place = CellGrid::Place;

  /// In whole nanometres, so that rounding does not choose between ways of one length.
  struct Open {
    std::int64_t estimate;
    std::int64_t cost;
    Index cell;
  };

  bool lay_out(const ObstacleField& field, const Query& query);
  bool mark_obstacles(const ObstacleField& field, const Query& query);
  std::vector<Index> cells_around(const ObstacleField& field, const Query& query, const Vec2& point) const;
  /// `last`: the cell where the path leaves the grid, or, without a way, the reached one nearest to the goal.
  End find(const ObstacleField& field, const Query& query, std::optional<Index>& last);
  void expand(const ObstacleField& field, const Query& query, Index from);
  void open(Index cell, double cost, Index parent);
  void trace(Index last, const Query& query, bool to_goal, std::vector<Vec2>& path) const;
  double estimate(Index cell) const;
  static bool later(const Open& a, const Open& b);

  CellGrid grid_;
  Vec2 goal_ = Vec2::Zero();  ///< in the grid's frame
  double longest_goal_leg_m_ = 0.0;
  std::vector<Open> open_;  ///< a heap
};

}  // namespace regista
