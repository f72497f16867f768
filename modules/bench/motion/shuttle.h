// A robot that goes to and fro between two points as fast as it can and knows nothing.
#pragma once

#include "world_model/types/geometry.h"
#include "world_model/types/robot_limits.h"

namespace regista::bench {

class Shuttle {
 public:
  /// From `a` to `b` and back: speeds up, drives at its top speed where there is room for it, brakes to a stand at the
  /// end, turns without a pause. Limits > 0.
  Shuttle(const Vec2& a, const Vec2& b, const RobotLimits& limits);

  /// Where it is time_s after it was at `phase` (0 … 1) of its time there and back.
  Vec2 place(double phase, double time_s) const;

 private:
  double driven_m(double time_s) const;

  Vec2 from_m_;
  Vec2 way_;  ///< unit; zero for no distance
  double distance_m_;
  double acceleration_mps2_, braking_mps2_;
  double top_mps_, cruise_s_;
};

}  // namespace regista::bench
