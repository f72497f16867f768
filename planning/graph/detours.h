// How much longer than straight a way must be because of what stands in between: lower bounds that let a search see
// which of its legs lead nowhere near, before it goes there.
#pragma once

#include <array>
#include <cstdint>
#include <experimental/simd>
#include <vector>

#include "planning/obstacle_field.h"

namespace regista::graph {

/// Each obstacle holds segments (gates) that no way crosses: a way from one side to the other passes one of the ends.
/// Of a disc, the diameter across the straight line; of others a few that are chosen once. The bound asks each gate
/// alone, without trigonometry. Only scratch memory is kept between two searches.
class Detours {
 public:
  void clear();

  /// One more that has to be gone round. A gate's end that lies out of bounds cannot be passed.
  void add(const Obstacle& obstacle, const Bounds& bounds);

  std::size_t size() const { return before_.size(); }

  /// No free way from one free point to the other is shorter. Metres; infinite where there is none. Asks those added as
  /// number `first` (from 0) and later, and perhaps some before.
  double least_m(const Vec2& from, const Vec2& to, std::size_t first = 0) const;

 private:
  using Lanes = std::experimental::native_simd<double>;
  static constexpr std::size_t kLanes = Lanes::size();

  struct Discs {
    std::array<double, kLanes> x{}, y{}, radius{};  ///< radius 0: none
  };
  struct Gate {
    Vec2 a, b;
    bool can_pass_at_a, can_pass_at_b;
  };

  void add_gate(const Vec2& middle, const Vec2& half, double radius_m, const Bounds& bounds);

  /// How many there were before an obstacle was added.
  struct Before {
    std::uint32_t discs, gates;
  };

  std::vector<Discs> discs_;
  std::vector<Gate> gates_;
  std::vector<Before> before_;  ///< by obstacle
  std::uint32_t disc_count_ = 0;
};

}  // namespace regista::graph
