#include "planning/graph/detours.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace regista::graph {
namespace {

/// Double precision rounds by 1e-16; sums and products of four numbers stay far below.
constexpr double kRounding = 1e-12;

/// Who is nearer to a gate's line than this share of all lengths is on it as far as crossings of lines can tell.
constexpr double kBeside = 1e-6;

/// Infinite where the end cannot be passed.
double past_end_m(const Vec2& from, const Vec2& end, bool can_pass, const Vec2& to) {
  return can_pass ? (end - from).norm() + (to - end).norm() : std::numeric_limits<double>::infinity();
}

}  // namespace

void Detours::clear() {
  discs_.clear();
  gates_.clear();
  before_.clear();
  disc_count_ = 0;
}

/// What touches is free: a gate ends that much earlier.
void Detours::add(const Obstacle& obstacle, const Bounds& bounds) {
  before_.push_back({disc_count_, static_cast<std::uint32_t>(gates_.size())});
  const double radius_m = obstacle.radius_m - kTouch_m -
                          kRounding * (obstacle.a.cwiseAbs().sum() + obstacle.b.cwiseAbs().sum() + obstacle.radius_m);
  const Vec2 middle = 0.5 * (obstacle.a + obstacle.b);
  const Vec2 half = 0.5 * (obstacle.b - obstacle.a);
  if (obstacle.a == obstacle.b) {
    const std::size_t lane = disc_count_++ % kLanes;
    if (lane == 0) discs_.emplace_back();
    discs_.back().x[lane] = middle.x();
    discs_.back().y[lane] = middle.y();
    discs_.back().radius[lane] = radius_m;
    return;
  }
  add_gate(middle, half, radius_m, bounds);
  if (obstacle.core == Core::segment) return;
  add_gate(middle, {half.x(), -half.y()}, radius_m, bounds);
  add_gate(middle, {half.x(), 0.0}, radius_m, bounds);
  add_gate(middle, {0.0, half.y()}, radius_m, bounds);
}

void Detours::add_gate(const Vec2& middle, const Vec2& half, double radius_m, const Bounds& bounds) {
  const double half_m = half.norm();
  if (half_m == 0.0 || radius_m <= 0.0) return;
  const Vec2 reach = half * (1.0 + radius_m / half_m);
  const Vec2 a = middle - reach;
  const Vec2 b = middle + reach;
  // A line that leaves the bounds does not come back.
  const bool meets_bounds = is_inside(middle, bounds);
  gates_.push_back({a, b, !meets_bounds || is_inside(a, bounds), !meets_bounds || is_inside(b, bounds)});
}

double Detours::least_m(const Vec2& from, const Vec2& to, std::size_t first) const {
  const Vec2 way = to - from;
  const double length_m = way.norm();
  if (length_m == 0.0 || first >= before_.size()) return length_m;
  const Vec2 along = way / length_m;
  const auto load = [](const std::array<double, kLanes>& column) {
    return Lanes(column.data(), std::experimental::element_aligned);
  };
  using std::experimental::sqrt;
  Lanes least = length_m;
  for (std::size_t block = before_[first].discs / kLanes; block < discs_.size(); ++block) {
    const Discs& discs = discs_[block];
    const Lanes x = load(discs.x) - from.x();
    const Lanes y = load(discs.y) - from.y();
    const Lanes before = along.x() * x + along.y() * y;
    const Lanes after = length_m - before;
    const Lanes aside = load(discs.radius) - std::experimental::abs(along.x() * y - along.y() * x);
    const Lanes round = sqrt(before * before + aside * aside) + sqrt(after * after + aside * aside);
    where(aside > 0.0 && before > 0.0 && after > 0.0 && round > least, least) = round;
  }
  double least_m = std::experimental::hmax(least);
  for (std::size_t i = before_[first].gates; i < gates_.size(); ++i) {
    const Gate& gate = gates_[i];
    const Vec2 across = gate.b - gate.a;
    if ((cross(way, gate.a - from) < 0.0) == (cross(way, gate.b - from) < 0.0)) continue;
    const double from_beside = cross(across, from - gate.a);
    const double to_beside = cross(across, to - gate.a);
    if ((from_beside < 0.0) == (to_beside < 0.0)) continue;
    // On the gate's own line the sides are rounding, and a way along it crosses nothing.
    const double unsure =
        kBeside * across.cwiseAbs().sum() * (from.cwiseAbs().sum() + to.cwiseAbs().sum() + gate.a.cwiseAbs().sum());
    if (std::abs(from_beside) <= unsure || std::abs(to_beside) <= unsure) continue;
    least_m = std::max(least_m, std::min(past_end_m(from, gate.a, gate.can_pass_at_a, to),
                                         past_end_m(from, gate.b, gate.can_pass_at_b, to)));
  }
  return least_m;
}

}  // namespace regista::graph
