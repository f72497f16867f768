// The discs that last blocked legs from about one place. What blocked a leg blocks its neighbours as well, and is asked
// before all obstacles are.
#pragma once

#include <array>
#include <cstddef>

#include "planning/obstacle_boxes.h"

namespace regista::graph {

/// A few discs in single precision, asked at once.
class Occluders {
 public:
  /// Forgets the oldest one. Of what is no disc, the disc around the middle of its core.
  void add(const Obstacle& obstacle);

  /// True: one of their obstacles blocks the motion for certain.
  bool surely_block(const ObstacleBoxes::Motion& motion) const;

 private:
  static constexpr std::size_t kCount = 4;

  alignas(sizeof(float) * kCount) std::array<float, kCount> x_{}, y_{};
  alignas(sizeof(float) * kCount) std::array<float, kCount> radius_{};  ///< less rounding; 0: blocks nothing
  std::size_t next_ = 0;
};

}  // namespace regista::graph
