#include "planning/planners/cell_grid.h"

#include <algorithm>

namespace regista {
namespace {

/// A grid of more cells than this is refused: 0.26 GB, a field of 141 × 141 m.
constexpr double kCellsMax = 8e6;

/// Cells on one side of the middle whose centres are within.
double half_count(double half_extent_m, double cell_m) { return std::floor((half_extent_m + kTouch_m) / cell_m + 0.5); }

}  // namespace

bool CellGrid::lay_out(const Bounds& bounds, const Vec2& signs) {
  const double half_columns = half_count(bounds.half_extent_m.x(), cell_m_);
  const double half_rows = half_count(bounds.half_extent_m.y(), cell_m_);
  const double count = 4.0 * half_columns * half_rows;
  if (count < 1.0 || count > kCellsMax) return false;
  columns_ = 2 * static_cast<std::int64_t>(half_columns);
  rows_ = 2 * static_cast<std::int64_t>(half_rows);
  if (cells_.size() < static_cast<std::size_t>(count)) cells_.resize(static_cast<std::size_t>(count));
  if (++generation_ == 0) {
    std::fill(cells_.begin(), cells_.end(), Cell{});
    generation_ = 1;
  }
  signs_ = signs;
  return true;
}

void CellGrid::mark(const Obstacle& obstacle) {
  const double near_m = (kDiagonal + 1e-6) * cell_m_;
  const Vec2 a = obstacle.a.cwiseProduct(signs_);
  const Vec2 b = obstacle.b.cwiseProduct(signs_);
  const Vec2 reach = Vec2::Constant(obstacle.radius_m + near_m);
  const Vec2 size(static_cast<double>(columns_), static_cast<double>(rows_));
  const Vec2 first = ((a.cwiseMin(b) - reach) / cell_m_ + 0.5 * size).cwiseMax(0.0).cwiseMin(size);
  const Vec2 last = ((a.cwiseMax(b) + reach) / cell_m_ + 0.5 * size).cwiseMax(0.0).cwiseMin(size);
  const auto column_end = std::min(columns_, static_cast<std::int64_t>(last.x()) + 1);
  const auto row_end = std::min(rows_, static_cast<std::int64_t>(last.y()) + 1);
  for (auto row = static_cast<std::int64_t>(first.y()); row < row_end; ++row) {
    for (auto column = static_cast<std::int64_t>(first.x()); column < column_end; ++column) {
      const Index i = index({column, row});
      Cell& marked = cell(i);
      if (marked.kind == Kind::covered) continue;
      const double clearance_m = clearance(centre(i), obstacle);
      if (clearance_m < -kTouch_m) {
        marked.kind = Kind::covered;
      } else if (clearance_m < near_m) {
        marked.kind = Kind::near;
      }
    }
  }
}

}  // namespace regista
