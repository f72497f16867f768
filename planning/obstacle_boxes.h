// Single-precision boxes around the cores of obstacles, several to a vector register: a test of a straight sweep
// against all obstacles that may report one too many, never one too few. Large fields are sorted into groups with a box
// each, so that a short sweep looks into few of them.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "planning/obstacle.h"
#include "planning/z_order.h"

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
    visit_near({from, to, length_m > 0.0 ? Vec2(along / length_m) : Vec2::Zero(), radius_m}, visit);
  }

  /// The same for one who knows the direction.
  struct Motion {
    const Vec2& from;
    const Vec2& to;
    const Vec2& along;  ///< unit, or zero
    double radius_m = 0.0;
  };
  template <class Visit>
  void visit_near(const Motion& motion, Visit&& visit) const;

 private:
  static constexpr std::size_t kLanes = 8;
  static constexpr std::size_t kGroupSize = 16;

  /// As many boxes as there are lanes, each grown by a radius.
  struct alignas(sizeof(float) * kLanes) Block {
    std::array<float, kLanes> x, y, half_x, half_y, radius;
    void set(std::size_t lane, const Obstacle& obstacle);
    void set_four(std::size_t lane, const std::array<const Obstacle*, 4>& obstacles);
    void set(std::size_t lane, const Vec2& middle, const Vec2& half, double radius_m);
    void pad(std::size_t lane);
  };

  struct Sweep {
    float x, y, half_x, half_y;  ///< of the segment's box, which is grown by the sweep's radius
    float along_x, along_y;      ///< unit vector, or zero
    float radius;
  };
  Sweep sweep_of(const Motion& motion) const;

  /// Bit i: box i of the blocks, which are at most kChunk boxes, may be near. All visits share this code: after other
  /// work the processor has to fetch it only once.
  static std::uint32_t hits(const Block* begin, const Block* end, const Sweep& sweep);
  static constexpr std::size_t kChunk = 32;

  /// Bits of the boxes of one group.
  using GroupHits = std::uint16_t;
  static_assert(kGroupSize == 16);

  /// The same for the boxes of those groups whose bits are set, bit 0 for the group that `blocks` begins with: of the
  /// first in hits[0], and so on, no more written than bits are set. All in one call, or the calls cost more than the
  /// boxes.
  static void group_hits(const Block* blocks, std::uint32_t groups, const Sweep& sweep,
                         std::array<GroupHits, kChunk>& hits);

  /// Calls visit(i) for the bits of `hits`, until it returns true; then true.
  template <class Visit>
  static bool visit_bits(std::uint32_t hits, Visit&& visit) {
    for (; hits != 0; hits &= hits - 1) {
      if (visit(static_cast<std::size_t>(std::countr_zero(hits)))) return true;
    }
    return false;
  }

  void sort_into_groups(std::span<const Obstacle> obstacles);

  std::vector<Block> blocks_;
  std::vector<Block> groups_;         ///< a box for kGroupSize boxes; empty in a small field
  std::vector<ObstacleIndex> index_;  ///< of the boxes' obstacles
  ZOrder order_;                      ///< scratch
  double extent_m_ = 0.0;             ///< no coordinate is larger
};

template <class Visit>
void ObstacleBoxes::visit_near(const Motion& motion, Visit&& visit) const {
  const Sweep sweep = sweep_of(motion);
  constexpr std::size_t kBlocks = kChunk / kLanes;
  const std::vector<Block>& top = groups_.empty() ? blocks_ : groups_;
  for (std::size_t first = 0; first < top.size(); first += kBlocks) {
    const Block* const begin = top.data() + first;
    const std::uint32_t near = hits(begin, top.data() + std::min(first + kBlocks, top.size()), sweep);
    if (groups_.empty()) {
      if (visit_bits(near, [&](std::size_t i) { return visit(index_[first * kLanes + i]); })) return;
      continue;
    }
    std::array<GroupHits, kChunk> of_groups;
    group_hits(blocks_.data() + first * kGroupSize, near, sweep, of_groups);
    const GroupHits* of_group = of_groups.data();
    const auto visit_group = [&](std::size_t i) {
      const ObstacleIndex* const index = index_.data() + (first * kLanes + i) * kGroupSize;
      return visit_bits(*of_group++, [&](std::size_t k) { return visit(index[k]); });
    };
    if (visit_bits(near, visit_group)) return;
  }
}

}  // namespace regista
