#include "planning/planners/dvg_region.h"

#include <limits>

namespace regista::dvg {

ActiveRegion::ActiveRegion(const Vec2& start, const Vec2& goal, double half_width_m, double overhang_m)
    : start_(start),
      along_((goal - start).stableNormalized()),
      length_m_((goal - start).norm()),
      half_width_m_(half_width_m),
      overhang_m_(overhang_m) {}

bool ActiveRegion::is_reached_by(std::span<const Vec2> vertices) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Vec2 low = Vec2::Constant(kInfinity);
  Vec2 high = -low;
  for (const Vec2& vertex : vertices) {
    const Vec2 from_start = vertex - start_;
    const Vec2 local(along_.dot(from_start), cross(along_, from_start));
    low = low.cwiseMin(local);
    high = high.cwiseMax(local);
  }
  return high.x() > -overhang_m_ && low.x() < length_m_ + overhang_m_ && high.y() > -half_width_m_ &&
         low.y() < half_width_m_;
}

}  // namespace regista::dvg
