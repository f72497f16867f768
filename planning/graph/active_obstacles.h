// The obstacles a search goes round, in the order in which they came into it: their boundaries, and a fast test of legs
// against all of them.
#pragma once

#include <experimental/simd>
#include <span>
#include <vector>

#include "planning/graph/body.h"
#include "planning/graph/contacts.h"
#include "planning/graph/occluders.h"
#include "planning/graph/tangents.h"
#include "planning/obstacle_field.h"

namespace regista::graph {

/// Slots are numbered from 0. Only scratch memory is kept between two searches.
class ActiveObstacles {
 public:
  struct Slot {
    const Body& body;  ///< the graph's, valid for its frame
    ObstacleIndex obstacle;
  };

  /// Where ways go on from.
  struct Departure {
    Vec2 point = Vec2::Zero();
    double cost_m = 0.0;  ///< of the way to the point
    Departures window;
  };

  /// For a field of so many obstacles.
  void clear(std::size_t obstacles);

  /// One more, which must not be there yet. Its body is not copied: it must stay where it is until the last use.
  void add(const ObstacleField& field, ObstacleIndex obstacle, const Body& body, const Vec2& goal);

  std::size_t size() const { return slots_.size(); }
  const Slot& operator[](std::uint32_t slot) const { return slots_[slot]; }
  bool contains(ObstacleIndex obstacle) const { return is_active_[obstacle] != 0; }

  /// By slot.
  std::span<const ObstacleIndex> list() const { return list_; }

  /// By slot: no way to the goal that departs there and touches that obstacle next is shorter, metres; infinite where
  /// no leg leads to it. Valid until the next call.
  std::span<const double> least_ways_m(const Departure& departure);

  /// The same for one, to the bit.
  double least_way_m(const Departure& departure, std::uint32_t slot) const;

  /// None of them blocks the motion, which touches those of slots `from` and `to` (which may be no slots) and does not
  /// cross them. What does becomes one of the occluders of such motions.
  bool are_clear_of(const ObstacleField& field, const ObstacleBoxes::Motion& motion, std::uint32_t from,
                    std::uint32_t to, Occluders& occluders) const;

 private:
  using Lanes = std::experimental::native_simd<double>;
  static constexpr std::size_t kLanes = Lanes::size();

  /// Discs around as many slots as there are lanes.
  struct Discs {
    std::array<double, kLanes> x{}, y{};   ///< middle
    std::array<double, kLanes> extent{};   ///< no point of the obstacle is farther from it
    std::array<double, kLanes> to_goal{};  ///< from the middle to the goal, less two extents
  };
  /// The core's box of a slot, and the radius, grown by what rounding may take away.
  struct Around {
    Vec2 middle;
    Vec2 half;
    double radius_m;
  };
  static Lanes least_m(const Departure& departure, const Discs& discs);
  bool are_few_clear_of(const ObstacleField& field, const ObstacleBoxes::Motion& motion, std::uint64_t others) const;

  std::vector<Slot> slots_;
  std::vector<Discs> discs_;          ///< by slot
  std::vector<Around> around_;        ///< by slot
  std::vector<double> least_ways_m_;  ///< scratch
  std::vector<ObstacleIndex> list_;
  ObstacleBoxes boxes_;                  ///< by slot
  std::vector<std::uint8_t> is_active_;  ///< by obstacle
};

}  // namespace regista::graph
