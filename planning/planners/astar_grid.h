// A* over the centres of square cells, eight neighbours: what Costa & Tonidandel decide against ("a 240 × 180 map", 3)
// and the "A*" of the iterative RRT paper's table I, of which neither says that its path was smoothed; this one is not.
#pragma once

#include <cstdint>
#include <optional>

#include "planning/planner.h"
#include "planning/planning_params.h"

namespace regista {

/// Cells lie symmetrically about the field's centre. Legs are free by the field's exact test; what is farther from all
/// obstacles than a leg is long needs none. Start and goal are joined to the nearest centres that they see: those of
/// the four cells around, else of the sixteen, and so on up to 8 × 8. A way narrower than a cell may be missed, so no
/// path is no proof. Of the path only the points where it turns are given.
/// Runs in a frame in which the goal lies ahead and to the left, so that mirrored worlds have mirrored paths in spite
/// of the many ways of one length that a grid has.
class AstarGrid : public Planner {
 public:
  explicit AstarGrid(const PlanningParams& params = {}) : AstarGrid(params.astar_grid) {}
  explicit AstarGrid(const AstarGridParams& params) : cell_m_(params.cell_m) {}

 protected:
  void search(graph::SharedGraph& graph, const Query& query, SearchResult& result) override;

 private:
  enum class End { goal, no_way, no_time };
  enum class Kind : std::uint8_t { clear, near, covered };
  using Index = std::uint32_t;

  struct Cell {
    double cost = 0.0;
    double to_goal_leg = 0.0;      ///< length of the leg to the goal; infinite where there is none
    Index parent = 0;              ///< itself when joined to the start
    std::uint32_t generation = 0;  ///< of the query that the rest belongs to
    Kind kind = Kind::clear;
    bool closed = false;
  };
  /// In whole nanometres, so that rounding does not choose between ways of one length.
  struct Open {
    std::int64_t estimate;
    std::int64_t cost;
    Index cell;
  };
  /// Whole numbers of cells from the first one.
  struct Place {
    std::int64_t column, row;
  };

  bool lay_out(const ObstacleField& field, const Query& query);
  bool mark_obstacles(const ObstacleField& field, const Query& query);
  void mark(const Obstacle& obstacle);
  std::vector<Index> cells_around(const ObstacleField& field, const Query& query, const Vec2& point) const;
  /// `last`: the cell where the path leaves the grid, or, without a way, the reached one nearest to the goal.
  End find(const ObstacleField& field, const Query& query, std::optional<Index>& last);
  void expand(const ObstacleField& field, const Query& query, Index from);
  void open(Index cell, double cost, Index parent);
  void trace(Index last, const Query& query, bool to_goal, std::vector<Vec2>& path) const;

  Cell& cell(Index index);
  Vec2 centre(Index index) const;
  Place place(Index index) const { return {index % columns_, index / columns_}; }
  Index index(const Place& place) const { return static_cast<Index>(place.row * columns_ + place.column); }
  bool exists(const Place& place) const;
  double estimate(Index cell) const;
  static bool later(const Open& a, const Open& b);

  double cell_m_;
  std::int64_t columns_ = 0;
  std::int64_t rows_ = 0;
  Vec2 signs_ = Vec2::Ones();  ///< from the frame of the search to the field's
  Vec2 goal_ = Vec2::Zero();
  double longest_goal_leg_m_ = 0.0;
  std::uint32_t generation_ = 0;
  std::vector<Cell> cells_;  ///< made once; generations say what is old
  std::vector<Open> open_;   ///< a heap
};

}  // namespace regista
