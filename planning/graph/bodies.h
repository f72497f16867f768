// The boundaries of a frame's obstacles, each laid out when it is first asked for, and kept for all robots.
#pragma once

#include <cstdint>
#include <vector>

#include "planning/graph/body.h"
#include "planning/obstacle_field.h"

namespace regista::graph {

class Bodies {
 public:
  /// Forgets everything without touching it; `obstacles`: how many the new field has.
  void reset(std::size_t obstacles) {
    ++frame_;
    if (known_.size() < obstacles) known_.resize(obstacles);
  }

  /// Valid until the next frame.
  const Body& of(const ObstacleField& field, ObstacleIndex obstacle) {
    Known& known = known_[obstacle];
    if (known.frame != frame_) known = {body_of(field.obstacles()[obstacle]), frame_};
    return known.body;
  }

 private:
  struct Known {
    Body body;
    std::uint64_t frame = 0;
  };

  std::vector<Known> known_;  ///< by obstacle
  std::uint64_t frame_ = 0;
};

}  // namespace regista::graph
