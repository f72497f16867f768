#include "planning/planners/astar_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace regista {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// No way over a grid is longer, and nanometres of it are whole numbers of 64 bits.
constexpr double kFarthest_m = 1e9;

/// A grid of more cells than this is refused: 0.26 GB, a field of 141 × 141 m.
constexpr double kCellsMax = 8e6;

/// How many obstacles are marked, or cells expanded, between two questions whether time is up.
constexpr std::size_t kPerTimeCheck = 64;

/// Start and goal look for centres as far as this many cells away.
constexpr std::int64_t kJoinReach = 4;

/// Length of a diagonal leg in cells, and what the octile distance may exceed the straight one by (at 22.5°).
constexpr double kDiagonal = std::numbers::sqrt2;
constexpr double kOctileExcess = 1.0823922002923940 - 1.0;

/// Lengths that differ by less are equal.
constexpr double kSameLength_m = 1e-9;

std::int64_t rounded(double length_m) { return std::llround(length_m / kSameLength_m); }

/// Cells on one side of the middle whose centres are within.
double half_count(double half_extent_m, double cell_m) { return std::floor((half_extent_m + kTouch_m) / cell_m + 0.5); }

}  // namespace

void AstarGrid::search(graph::SharedGraph& graph, const Query& query, SearchResult& result) {
  const ObstacleField& field = graph.field();
  if ((query.goal - query.start).norm() <= cell_m_ && query.is_straight_free) {
    result.path = {query.start, query.goal};
    result.status = PlanStatus::ok;
    return;
  }
  if (!lay_out(field, query)) {
    result.reason = "a grid of such cells over this field has no cell or too many";
    return;
  }
  std::optional<Index> last;
  const End end = mark_obstacles(field, query) ? find(field, query, last) : End::no_time;
  if (last) trace(*last, query, end == End::goal, result.path);
  if (end == End::goal) {
    result.status = PlanStatus::ok;
  } else {
    result.reason = end == End::no_time ? "the time was spent" : "no way over the grid";
  }
}

/// False when the field has no cell or too many.
bool AstarGrid::lay_out(const ObstacleField& field, const Query& query) {
  const Vec2 half_extent = field.bounds().half_extent_m;
  const double half_columns = half_count(half_extent.x(), cell_m_);
  const double half_rows = half_count(half_extent.y(), cell_m_);
  const double count = 4.0 * half_columns * half_rows;
  if (count < 1.0 || count > kCellsMax) return false;
  columns_ = 2 * static_cast<std::int64_t>(half_columns);
  rows_ = 2 * static_cast<std::int64_t>(half_rows);
  if (cells_.size() < static_cast<std::size_t>(count)) cells_.resize(static_cast<std::size_t>(count));
  if (++generation_ == 0) {
    std::fill(cells_.begin(), cells_.end(), Cell{});
    generation_ = 1;
  }
  signs_ = {query.goal.x() < query.start.x() ? -1.0 : 1.0, query.goal.y() < query.start.y() ? -1.0 : 1.0};
  goal_ = query.goal.cwiseProduct(signs_);
  longest_goal_leg_m_ = 0.0;
  open_.clear();
  return true;
}

/// False when the time was up.
bool AstarGrid::mark_obstacles(const ObstacleField& field, const Query& query) {
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (i % kPerTimeCheck == 0 && query.budget.is_spent()) return false;
    if (!is_ignored(static_cast<ObstacleIndex>(i), query.ignored)) mark(field.obstacles()[i]);
  }
  return true;
}

/// Cells whose centres it covers, and those nearer than a leg is long.
void AstarGrid::mark(const Obstacle& obstacle) {
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

std::vector<AstarGrid::Index> AstarGrid::cells_around(const ObstacleField& field, const Query& query,
                                                      const Vec2& point) const {
  std::vector<Index> seen;
  const Vec2 local = point.cwiseProduct(signs_) / cell_m_;
  const auto column = static_cast<std::int64_t>(std::floor(local.x() - 0.5)) + columns_ / 2;
  const auto row = static_cast<std::int64_t>(std::floor(local.y() - 0.5)) + rows_ / 2;
  for (std::int64_t reach = 1; reach <= kJoinReach && seen.empty(); ++reach) {
    for (std::int64_t r = row - reach + 1; r <= row + reach; ++r) {
      for (std::int64_t c = column - reach + 1; c <= column + reach; ++c) {
        if (exists({c, r}) && field.is_free(point, centre(index({c, r})), query.ignored)) seen.push_back(index({c, r}));
      }
    }
  }
  return seen;
}

AstarGrid::End AstarGrid::find(const ObstacleField& field, const Query& query, std::optional<Index>& last) {
  for (const Index i : cells_around(field, query, query.goal)) {
    cell(i).to_goal_leg = (query.goal - centre(i)).norm();
    longest_goal_leg_m_ = std::max(longest_goal_leg_m_, cell(i).to_goal_leg);
  }
  for (const Index i : cells_around(field, query, query.start)) open(i, (centre(i) - query.start).norm(), i);
  if (open_.empty()) return End::no_way;
  double goal_cost = kFarthest_m;
  Index nearest = open_.front().cell;
  for (std::size_t expanded = 0; !open_.empty() && open_.front().estimate < rounded(goal_cost);) {
    const Index at = open_.front().cell;
    std::pop_heap(open_.begin(), open_.end(), later);
    open_.pop_back();
    Cell& here = cells_[at];
    if (here.closed) continue;
    here.closed = true;
    if (expanded++ % kPerTimeCheck == 0 && query.budget.is_spent()) {
      last = nearest;
      return End::no_time;
    }
    if (estimate(at) < estimate(nearest)) nearest = at;
    if (here.cost + here.to_goal_leg < goal_cost - kSameLength_m) {
      goal_cost = here.cost + here.to_goal_leg;
      last = at;
    }
    expand(field, query, at);
  }
  if (goal_cost < kFarthest_m) return End::goal;
  last = nearest;
  return End::no_way;
}

void AstarGrid::expand(const ObstacleField& field, const Query& query, Index from) {
  const Place here = place(from);
  const Vec2 position = centre(from);
  const bool is_clear = cells_[from].kind == Kind::clear;
  for (const Place& step :
       {Place{1, 1}, Place{1, 0}, Place{0, 1}, Place{1, -1}, Place{-1, 1}, Place{0, -1}, Place{-1, 0}, Place{-1, -1}}) {
    const Place there{here.column + step.column, here.row + step.row};
    if (!exists(there)) continue;
    const Index to = index(there);
    const Cell& next = cell(to);
    const bool is_diagonal = step.column != 0 && step.row != 0;
    const double cost = cells_[from].cost + cell_m_ * (is_diagonal ? kDiagonal : 1.0);
    if (next.closed || next.kind == Kind::covered || cost >= next.cost - kSameLength_m) continue;
    const bool must_ask = !is_clear && next.kind == Kind::near;
    if (must_ask && !field.is_free(position, centre(to), query.ignored)) continue;
    open(to, cost, from);
  }
}

void AstarGrid::open(Index index, double cost, Index parent) {
  Cell& opened = cell(index);
  opened.cost = cost;
  opened.parent = parent;
  open_.push_back({rounded(cost + estimate(index)), rounded(cost), index});
  std::push_heap(open_.begin(), open_.end(), later);
}

void AstarGrid::trace(Index last, const Query& query, bool to_goal, std::vector<Vec2>& path) const {
  path.clear();
  if (to_goal) path.push_back(query.goal);
  // A centre is left out when the path passes it straight; start and goal lie off the grid.
  const auto turns = [&](Index before, Index at, Index after) {
    const Place a = place(before);
    const Place b = place(at);
    const Place c = place(after);
    return b.column - a.column != c.column - b.column || b.row - a.row != c.row - b.row;
  };
  Index after = last;
  Index at = last;
  for (;; after = at, at = cells_[at].parent) {
    const Index before = cells_[at].parent;
    if (at == last || before == at || turns(before, at, after)) path.push_back(centre(at));
    if (before == at) break;
  }
  path.push_back(query.start);
  std::reverse(path.begin(), path.end());
}

/// As this query left it, or new.
AstarGrid::Cell& AstarGrid::cell(Index index) {
  Cell& found = cells_[index];
  if (found.generation != generation_) found = {kInfinity, kInfinity, index, generation_, Kind::clear, false};
  return found;
}

/// In the field's frame.
Vec2 AstarGrid::centre(Index index) const {
  const Place at = place(index);
  // As many columns and rows on either side of the middle.
  const auto column = at.column - columns_ / 2;
  const auto row = at.row - rows_ / 2;
  const Vec2 cells(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
  return cells.cwiseProduct(signs_) * cell_m_;
}

bool AstarGrid::exists(const Place& place) const {
  return place.column >= 0 && place.column < columns_ && place.row >= 0 && place.row < rows_;
}

/// Never more than what is left to the goal: the octile distance, but the last leg is straight.
double AstarGrid::estimate(Index cell) const {
  const Vec2 left = (goal_ - centre(cell).cwiseProduct(signs_)).cwiseAbs();
  const double octile_m = left.maxCoeff() + (kDiagonal - 1.0) * left.minCoeff();
  return std::max(0.0, octile_m - kOctileExcess * longest_goal_leg_m_);
}

/// Of equal estimates the one farther on comes first.
bool AstarGrid::later(const Open& a, const Open& b) {
  if (a.estimate != b.estimate) return a.estimate > b.estimate;
  return a.cost != b.cost ? a.cost < b.cost : a.cell > b.cell;
}

}  // namespace regista
