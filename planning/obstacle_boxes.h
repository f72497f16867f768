// Single-precision boxes around the cores of obstacles, several to a vector register: a test of a straight sweep
// against all obstacles that may report one too many, never one too few. Large fields are sorted into groups with a box
// each, so that a short sweep looks into few of them.
#pragma once

#include <bit>
#include <cstdint>
#include <experimental/simd>
#include <span>
#include <utility>
#include <vector>

#include "planning/obstacle.h"

namespace regista {

/// Index of an obstacle within its field.
using ObstacleIndex = std::uint32_t;

class ObstacleBoxes {
 public:
  /// In the memory of the old ones. Obstacles must be valid.
  void assign(std::span<const Obstacle> obstacles);

  /// Calls visit(index) for each obstacle that comes nearer than radius_m to the segment, and for some that do not,
  /// until visit returns true. The order is the same for the same obstacles.
  template <class Visit>
  void visit_near(const Vec2& from, const Vec2& to, double radius_m, Visit&& visit) const;

 private:
  using Lanes = std::experimental::native_simd<float>;
  static constexpr std::size_t kGroupSize = 16;

  /// Boxes grown by a radius, padded to whole vectors with boxes that nothing meets.
  struct Columns {
    std::vector<float> x, y, half_x, half_y, radius;
    void clear();
    void add(const Vec2& low, const Vec2& high, double radius_m);
    void pad();
  };

  /// The segment as all lanes see it.
  struct Sweep {
    Lanes x, y, half_x, half_y;  ///< of its box
    Lanes along_x, along_y;      ///< unit vector, or zero
    Lanes across_x, across_y;    ///< magnitudes of the unit vector across
    Lanes radius;
    Sweep(const Vec2& from, const Vec2& to, double radius_m);
  };

  static Lanes load(const std::vector<float>& column, std::size_t i) {
    return Lanes(&column[i], std::experimental::element_aligned);
  }

  /// Separated along x, along y, or across the segment; for a point as core the last is the exact distance to the line.
  static unsigned hits(const Columns& columns, std::size_t i, const Sweep& sweep) {
    using std::experimental::abs;
    const Lanes x = load(columns.x, i) - sweep.x;
    const Lanes y = load(columns.y, i) - sweep.y;
    const Lanes half_x = load(columns.half_x, i);
    const Lanes half_y = load(columns.half_y, i);
    const Lanes radius = load(columns.radius, i) + sweep.radius;
    const auto hit =
        abs(x) <= half_x + (radius + sweep.half_x) && abs(y) <= half_y + (radius + sweep.half_y) &&
        abs(sweep.along_x * y - sweep.along_y * x) <= sweep.across_x * half_x + (sweep.across_y * half_y + radius);
    return static_cast<unsigned>(hit.__to_bitset().to_ulong());
  }

  template <class Visit>
  bool visit_boxes(std::size_t begin, std::size_t end, const Sweep& sweep, Visit& visit) const {
    for (std::size_t i = begin; i < end; i += Lanes::size()) {
      for (unsigned hit = hits(boxes_, i, sweep); hit != 0; hit &= hit - 1) {
        if (visit(index_[i + static_cast<std::size_t>(std::countr_zero(hit))])) return true;
      }
    }
    return false;
  }

  void assign_groups(std::span<const Obstacle> obstacles);

  Columns boxes_;
  Columns groups_;                                              ///< one for kGroupSize boxes; empty in a small field
  std::vector<ObstacleIndex> index_;                            ///< of the boxes' obstacles
  std::vector<std::pair<std::uint64_t, ObstacleIndex>> order_;  ///< scratch
  double extent_m_ = 0.0;                                       ///< no coordinate is larger
};

template <class Visit>
void ObstacleBoxes::visit_near(const Vec2& from, const Vec2& to, double radius_m, Visit&& visit) const {
  const double extent_m = std::max({extent_m_, from.cwiseAbs().maxCoeff(), to.cwiseAbs().maxCoeff()});
  // Single precision rounds by 6e-8; sums and products of four numbers stay below ten times that.
  const Sweep sweep(from, to, radius_m + 1e-6 * extent_m);
  if (groups_.x.empty()) {
    visit_boxes(0, boxes_.x.size(), sweep, visit);
    return;
  }
  for (std::size_t i = 0; i < groups_.x.size(); i += Lanes::size()) {
    for (unsigned hit = hits(groups_, i, sweep); hit != 0; hit &= hit - 1) {
      const std::size_t begin = (i + static_cast<std::size_t>(std::countr_zero(hit))) * kGroupSize;
      if (visit_boxes(begin, std::min(begin + kGroupSize, boxes_.x.size()), sweep, visit)) return;
    }
  }
}

}  // namespace regista
