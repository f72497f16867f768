// The obstacles a search goes round, in the order in which they came into it: their boundaries, and how short a way
// over each of them may be.
#pragma once

#include <experimental/simd>
#include <span>
#include <vector>

#include "planning/graph/blocker_set.h"
#include "planning/graph/body.h"
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
  bool contains(ObstacleIndex obstacle) const { return blockers_.contains(obstacle); }

  /// By slot.
  std::span<const ObstacleIndex> list() const { return blockers_.list(); }

  /// The same obstacles, to test motions against.
  const BlockerSet& blockers() const { return blockers_; }

  /// By slot: no way to the goal that departs there and touches that obstacle next is shorter, metres; infinite where
  /// no leg leads to it. Valid until the next call.
  std::span<const double> least_ways_m(const Departure& departure);

  /// The same for one, to the bit.
  double least_way_m(const Departure& departure, std::uint32_t slot) const;

 private:
  using Lanes = std::experimental::native_simd<double>;
  static constexpr std::size_t kLanes = Lanes::size();

  /// Discs around as many slots as there are lanes.
  struct Discs {
    std::array<double, kLanes> x{}, y{};   ///< middle
    std::array<double, kLanes> extent{};   ///< no point of the obstacle is farther from it
    std::array<double, kLanes> to_goal{};  ///< from the middle to the goal, less two extents
  };
  static Lanes least_m(const Departure& departure, const Discs& discs);

  std::vector<Slot> slots_;
  std::vector<Discs> discs_;          ///< by slot
  std::vector<double> least_ways_m_;  ///< scratch
  BlockerSet blockers_;
};

}  // namespace regista::graph
