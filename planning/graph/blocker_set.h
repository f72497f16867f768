// Obstacles that a search has run into: a fast test of motions against all of them, for what blocked one blocks many.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "planning/graph/occluders.h"
#include "planning/obstacle_field.h"

namespace regista::graph {

/// Slots are numbered from 0, in the order in which obstacles came in. Only scratch memory is kept between two
/// searches.
class BlockerSet {
 public:
  /// No slot.
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// For a field of so many obstacles.
  void clear(std::size_t obstacles);

  /// One more, which must not be there yet.
  void add(const ObstacleField& field, ObstacleIndex obstacle);

  std::size_t size() const { return list_.size(); }
  bool contains(ObstacleIndex obstacle) const { return is_in_[obstacle] != 0; }

  /// By slot.
  std::span<const ObstacleIndex> list() const { return list_; }

  /// They are looked at one by one, without asking the occluders first: most legs of a tangent search are free of so
  /// few. Where most motions are blocked, that is worth doing before.
  bool is_few() const { return list_.size() <= kFew; }

  /// None of them blocks the motion; those of slots `from` and `to` (or kNone) it touches without crossing them, and
  /// they are not asked. What does block becomes one of the occluders, which are of motions like this one.
  bool are_clear_of(const ObstacleField& field, const ObstacleBoxes::Motion& motion, std::uint32_t from,
                    std::uint32_t to, Occluders& occluders) const;

 private:
  static constexpr std::size_t kFew = 4;

  /// The core's box of a slot, and the radius, grown by what rounding may take away.
  struct Around {
    Vec2 middle;
    Vec2 half;
    double radius_m;
  };
  bool are_few_clear_of(const ObstacleField& field, const ObstacleBoxes::Motion& motion, std::uint64_t others,
                        Occluders& occluders) const;

  std::vector<Around> around_;  ///< by slot, of the first few
  std::vector<ObstacleIndex> list_;
  ObstacleBoxes boxes_;              ///< by slot
  std::vector<std::uint8_t> is_in_;  ///< by obstacle
};

}  // namespace regista::graph
