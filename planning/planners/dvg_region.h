// The active region: DVG looks at objects in it alone. "Given the start and goal points, S and G, the active region is
// the rectangle that is parallel to the segment SG, has a width of 2d_AR and a length of SG" (Costa & Tonidandel, 3.1).
#pragma once

#include <span>

#include "world_model/types/geometry.h"

namespace regista::dvg {

class ActiveRegion {
 public:
  /// `overhang_m`: how far it goes beyond start and goal; 0 as published.
  ActiveRegion(const Vec2& start, const Vec2& goal, double half_width_m, double overhang_m = 0.0);

  /// Whether an object with these corners reaches into it. The paper does not say what "in" is; of two convex shapes
  /// this compares what they span along and across the line, which takes some objects near its corners too many.
  bool is_reached_by(std::span<const Vec2> vertices) const;

 private:
  Vec2 start_;
  Vec2 along_;  ///< unit, or zero when start = goal
  double length_m_ = 0.0;
  double half_width_m_ = 0.0;
  double overhang_m_ = 0.0;
};

}  // namespace regista::dvg
