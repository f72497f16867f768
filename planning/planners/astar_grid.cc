#include "planning/planners/astar_grid.h"

#include <algorithm>
#include <cmath>

namespace regista {
namespace {

/// No way over a grid is longer, and nanometres of it are whole numbers of 64 bits.
constexpr double kFarthest_m = 1e9;

/// How many obstacles are marked, or cells expanded, between two questions whether time is up.
constexpr std::size_t kPerTimeCheck = 64;

/// Start and goal look for centres as far as this many cells away.
constexpr std::int64_t kJoinReach = 4;

/// What the octile distance may exceed the straight one by (at 22.5°).
constexpr double kOctileExcess = 1.0823922002923940 - 1.0;

/// Lengths that differ by less are equal.
constexpr double kSameLength_m = 1e-9;

std::int64_t rounded(double length_m) { return std::llround(length_m / kSameLength_m); }

}  // namespace

void AstarGrid::search(graph::SharedGraph& graph, const Query& query, SearchResult& result) {
  const ObstacleField& field = graph.field();
  if ((query.goal - query.start).norm() <= grid_.cell_m() && query.is_straight_free) {
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
  const Vec2 signs(query.goal.x() < query.start.x() ? -1.0 : 1.0, query.goal.y() < query.start.y() ? -1.0 : 1.0);
  if (!grid_.lay_out(field.bounds(), signs)) return false;
  goal_ = query.goal.cwiseProduct(signs);
  longest_goal_leg_m_ = 0.0;
  open_.clear();
  return true;
}

/// False when the time was up.
bool AstarGrid::mark_obstacles(const ObstacleField& field, const Query& query) {
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (i % kPerTimeCheck == 0 && query.budget.is_spent()) return false;
    if (!is_ignored(static_cast<ObstacleIndex>(i), query.ignored)) grid_.mark(field.obstacles()[i]);
  }
  return true;
}

std::vector<AstarGrid::Index> AstarGrid::cells_around(const ObstacleField& field, const Query& query,
                                                      const Vec2& point) const {
  std::vector<Index> seen;
  const Place before = grid_.before(point);
  for (std::int64_t reach = 1; reach <= kJoinReach && seen.empty(); ++reach) {
    for (std::int64_t row = before.row - reach + 1; row <= before.row + reach; ++row) {
      for (std::int64_t column = before.column - reach + 1; column <= before.column + reach; ++column) {
        if (!grid_.exists({column, row})) continue;
        const Index i = grid_.index({column, row});
        if (field.is_free(point, grid_.centre(i), query.ignored)) seen.push_back(i);
      }
    }
  }
  return seen;
}

AstarGrid::End AstarGrid::find(const ObstacleField& field, const Query& query, std::optional<Index>& last) {
  for (const Index i : cells_around(field, query, query.goal)) {
    grid_.cell(i).to_goal_leg = (query.goal - grid_.centre(i)).norm();
    longest_goal_leg_m_ = std::max(longest_goal_leg_m_, grid_.cell(i).to_goal_leg);
  }
  for (const Index i : cells_around(field, query, query.start)) open(i, (grid_.centre(i) - query.start).norm(), i);
  if (open_.empty()) return End::no_way;
  double goal_cost = kFarthest_m;
  Index nearest = open_.front().cell;
  for (std::size_t expanded = 0; !open_.empty() && open_.front().estimate < rounded(goal_cost);) {
    const Index at = open_.front().cell;
    std::pop_heap(open_.begin(), open_.end(), later);
    open_.pop_back();
    Cell& here = grid_.cell(at);
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
  const Place here = grid_.place(from);
  const Vec2 position = grid_.centre(from);
  const bool is_clear = grid_.visited(from).kind == Kind::clear;
  for (const Place& step :
       {Place{1, 1}, Place{1, 0}, Place{0, 1}, Place{1, -1}, Place{-1, 1}, Place{0, -1}, Place{-1, 0}, Place{-1, -1}}) {
    const Place there{here.column + step.column, here.row + step.row};
    if (!grid_.exists(there)) continue;
    const Index to = grid_.index(there);
    const Cell& next = grid_.cell(to);
    const bool is_diagonal = step.column != 0 && step.row != 0;
    const double cost = grid_.visited(from).cost + grid_.cell_m() * (is_diagonal ? CellGrid::kDiagonal : 1.0);
    if (next.closed || next.kind == Kind::covered || cost >= next.cost - kSameLength_m) continue;
    const bool must_ask = !is_clear && next.kind == Kind::near;
    if (must_ask && !field.is_free(position, grid_.centre(to), query.ignored)) continue;
    open(to, cost, from);
  }
}

void AstarGrid::open(Index index, double cost, Index parent) {
  Cell& opened = grid_.cell(index);
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
    const Place a = grid_.place(before);
    const Place b = grid_.place(at);
    const Place c = grid_.place(after);
    return b.column - a.column != c.column - b.column || b.row - a.row != c.row - b.row;
  };
  Index after = last;
  Index at = last;
  for (;; after = at, at = grid_.visited(at).parent) {
    const Index before = grid_.visited(at).parent;
    if (at == last || before == at || turns(before, at, after)) path.push_back(grid_.centre(at));
    if (before == at) break;
  }
  path.push_back(query.start);
  std::reverse(path.begin(), path.end());
}

/// Never more than what is left to the goal: the octile distance, but the last leg is straight.
double AstarGrid::estimate(Index cell) const {
  const Vec2 left = (goal_ - grid_.centre(cell).cwiseProduct(grid_.signs())).cwiseAbs();
  const double octile_m = left.maxCoeff() + (CellGrid::kDiagonal - 1.0) * left.minCoeff();
  return std::max(0.0, octile_m - kOctileExcess * longest_goal_leg_m_);
}

/// Of equal estimates the one farther on comes first.
bool AstarGrid::later(const Open& a, const Open& b) {
  if (a.estimate != b.estimate) return a.estimate > b.estimate;
  return a.cost != b.cost ? a.cost < b.cost : a.cell > b.cell;
}

}  // namespace regista
