// Single-precision boxes around the cores of obstacles, several to a vector register: a test of a straight sweep
// against all obstacles that may report one too many, never one too few. Large fields are sorted into groups with a box
// each, so that a short sweep looks into few of them.
#pragma once

#include <algorithm>
#include <array>
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

  /// For a list that grows: one more, under an index of the caller's. Without groups, so for few.
  void append(const Obstacle& obstacle, ObstacleIndex index);
  void clear();

  /// Calls visit(index) for each obstacle that comes nearer than radius_m to the segment, and for some that do not,
  /// until visit returns true. The order is the same for the same obstacles.
  template <class Visit>
  void visit_near(const Vec2& from, const Vec2& to, double radius_m, Visit&& visit) const {
    const Vec2 along = to - from;
    const double length_m = along.norm();
    visit_near({from, to, length_m > 0.0 ? Vec2(along / length_m) : Vec2::Zero(), radius_m, 0}, visit);
  }

  /// The same for one who knows the direction.
  struct Motion {
    const Vec2& from;
    const Vec2& to;
    const Vec2& along;  ///< unit, or zero
    double radius_m = 0.0;
    /// Bit i: the obstacle at place i of the list need not be visited, but may; for the first 64.
    std::uint64_t left_out = 0;
  };
  template <class Visit>
  void visit_near(const Motion& motion, Visit&& visit) const;

 private:
  using Lanes = std::experimental::native_simd<float>;
  static constexpr std::size_t kLanes = Lanes::size();
  static constexpr std::size_t kGroupSize = 16;

  /// As many boxes as there are lanes, each grown by a radius.
  struct alignas(sizeof(float) * kLanes) Block {
    std::array<float, kLanes> x, y, half_x, half_y, radius;
    void set(std::size_t lane, const Vec2& low, const Vec2& high, double radius_m);
    void pad(std::size_t lane);
  };

  /// The segment as all lanes see it.
  struct Sweep {
    Lanes x, y, half_x, half_y;  ///< of its box, which is grown by the sweep's radius
    Lanes along_x, along_y;      ///< unit vector, or zero
    Lanes across_x, across_y;    ///< magnitudes of the unit vector across
    Lanes radius;

    Sweep(const Motion& motion, double radius_m) {
      const Vec2 half = 0.5 * (motion.to - motion.from);
      const auto unit_x = static_cast<float>(motion.along.x());
      const auto unit_y = static_cast<float>(motion.along.y());
      x = static_cast<float>(motion.from.x() + half.x());
      y = static_cast<float>(motion.from.y() + half.y());
      half_x = static_cast<float>(std::abs(half.x()) + radius_m);
      half_y = static_cast<float>(std::abs(half.y()) + radius_m);
      along_x = unit_x;
      along_y = unit_y;
      across_x = std::abs(unit_y);
      across_y = std::abs(unit_x);
      radius = static_cast<float>(radius_m);
    }
  };

  static Lanes load(const std::array<float, kLanes>& column) {
    return Lanes(column.data(), std::experimental::vector_aligned);
  }

  /// Not separated along x, along y, or across the segment (for a point as core, exactly by its distance to the line).
  static unsigned hits(const Block& block, const Sweep& sweep) {
    using std::experimental::abs;
    const Lanes x = load(block.x) - sweep.x;
    const Lanes y = load(block.y) - sweep.y;
    const Lanes half_x = load(block.half_x);
    const Lanes half_y = load(block.half_y);
    const Lanes radius = load(block.radius);
    const auto hit = abs(x) <= half_x + (radius + sweep.half_x) && abs(y) <= half_y + (radius + sweep.half_y) &&
                     abs(sweep.along_x * y - sweep.along_y * x) <=
                         sweep.across_x * half_x + (sweep.across_y * half_y + (radius + sweep.radius));
    return static_cast<unsigned>(hit.__to_bitset().to_ulong());
  }

  template <class Visit>
  bool visit_blocks(std::size_t begin, std::size_t end, const Sweep& sweep, std::uint64_t left_out,
                    Visit& visit) const {
    for (std::size_t i = begin; i < end; ++i, left_out >>= kLanes) {
      for (unsigned hit = hits(blocks_[i], sweep) & ~static_cast<unsigned>(left_out); hit != 0; hit &= hit - 1) {
        if (visit(index_[i * kLanes + static_cast<std::size_t>(std::countr_zero(hit))])) return true;
      }
    }
    return false;
  }

  void sort_into_groups(std::span<const Obstacle> obstacles);

  std::vector<Block> blocks_;
  std::vector<Block> groups_;                                   ///< a box for kGroupSize boxes; empty in a small field
  std::vector<ObstacleIndex> index_;                            ///< of the boxes' obstacles
  std::vector<std::pair<std::uint64_t, ObstacleIndex>> order_;  ///< scratch
  double extent_m_ = 0.0;                                       ///< no coordinate is larger
};

template <class Visit>
void ObstacleBoxes::visit_near(const Motion& motion, Visit&& visit) const {
  const double extent_m = std::max({extent_m_, std::abs(motion.from.x()), std::abs(motion.from.y()),
                                    std::abs(motion.to.x()), std::abs(motion.to.y())});
  // Single precision rounds by 6e-8; sums and products of four numbers stay below ten times that.
  const Sweep sweep(motion, motion.radius_m + 1e-6 * extent_m);
  if (groups_.empty()) {
    visit_blocks(0, blocks_.size(), sweep, motion.left_out, visit);
    return;
  }
  constexpr std::size_t kBlocks = kGroupSize / kLanes;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    for (unsigned hit = hits(groups_[i], sweep); hit != 0; hit &= hit - 1) {
      const std::size_t begin = (i * kLanes + static_cast<std::size_t>(std::countr_zero(hit))) * kBlocks;
      if (visit_blocks(begin, std::min(begin + kBlocks, blocks_.size()), sweep, 0, visit)) return;
    }
  }
}

}  // namespace regista
