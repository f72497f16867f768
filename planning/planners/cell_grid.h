// Square cells over a field, each with what covers it or comes near it and with the memory that a search needs: what
// planners/astar_grid.h searches.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "planning/obstacle_field.h"

namespace regista {

/// Cells lie symmetrically about the field's centre, as many on either side of it, and are counted in a frame that may
/// be mirrored against the field's. Points are in the field's frame.
class CellGrid {
 public:
  enum class Kind : std::uint8_t { clear, near, covered };
  using Index = std::uint32_t;

  /// Length of a leg to a diagonal neighbour, in cells.
  static constexpr double kDiagonal = std::numbers::sqrt2;

  struct Cell {
    double cost = 0.0;
    double to_goal_leg = 0.0;      ///< length of the leg to the goal; infinite where there is none
    Index parent = 0;              ///< itself when joined to the start
    std::uint32_t generation = 0;  ///< of the query that the rest belongs to
    Kind kind = Kind::clear;
    bool closed = false;
  };
  /// Whole numbers of cells from the first one.
  struct Place {
    std::int64_t column, row;
  };

  explicit CellGrid(double cell_m) : cell_m_(cell_m) {}

  /// Begins a query: all cells are new. Signs, each 1 or -1, lead from the grid's frame to the field's. False when the
  /// bounds hold no cell or too many.
  bool lay_out(const Bounds& bounds, const Vec2& signs);

  /// Cells whose centres it covers, and those nearer than a leg is long.
  void mark(const Obstacle& obstacle);

  /// As this query left it, or new.
  Cell& cell(Index index) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Cell& found = cells_[index];
    if (found.generation != generation_) found = {kInfinity, kInfinity, index, generation_, Kind::clear, false};
    return found;
  }
  /// The same for one that cell() gave to this query.
  const Cell& visited(Index index) const { return cells_[index]; }

  Vec2 centre(Index index) const {
    const Place at = place(index);
    const auto column = at.column - columns_ / 2;
    const auto row = at.row - rows_ / 2;
    const Vec2 cells(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
    return cells.cwiseProduct(signs_) * cell_m_;
  }

  /// The last cell whose centre lies before the point on both axes of the grid; it need not exist.
  Place before(const Vec2& point) const {
    const Vec2 local = point.cwiseProduct(signs_) / cell_m_;
    return {static_cast<std::int64_t>(std::floor(local.x() - 0.5)) + columns_ / 2,
            static_cast<std::int64_t>(std::floor(local.y() - 0.5)) + rows_ / 2};
  }

  Place place(Index index) const { return {index % columns_, index / columns_}; }
  Index index(const Place& place) const { return static_cast<Index>(place.row * columns_ + place.column); }
  bool exists(const Place& place) const {
    return place.column >= 0 && place.column < columns_ && place.row >= 0 && place.row < rows_;
  }

  double cell_m() const { return cell_m_; }
  const Vec2& signs() const { return signs_; }

 private:
  double cell_m_;
  std::int64_t columns_ = 0;
  std::int64_t rows_ = 0;
  Vec2 signs_ = Vec2::Ones();
  std::uint32_t generation_ = 0;
  std::vector<Cell> cells_;  ///< made once; generations say what is old
};

}  // namespace regista
