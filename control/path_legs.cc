#include "control/path_legs.h"

#include <cmath>
#include <limits>

namespace regista {
namespace {

/// Leaving out legs shorter than this moves the path by less than vision can see, 1.3 mm.
constexpr double kLegMin_m = 1e-3;

}  // namespace

std::size_t nearest_leg(std::span<const Vec2> path, const Vec2& position_m) {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double squared = (position_m - nearest_on_segment(position_m, path[i], path[i + 1])).squaredNorm();
    if (squared > least) continue;
    least = squared;
    nearest = i;
  }
  return nearest;
}

std::vector<Leg> legs_ahead(std::span<const Vec2> path, const Vec2& position_m) {
  std::vector<Leg> legs;
  const std::size_t first = nearest_leg(path, position_m);
  legs.reserve(path.size() - first);
  Vec2 from = path[first];
  for (std::size_t i = first + 1; i < path.size(); ++i) {
    const Vec2 way = path[i] - from;
    const double length_m = way.norm();
    if (length_m <= kLegMin_m) continue;
    legs.push_back({from, way / length_m, length_m, 0.0});
    from = path[i];
  }
  for (std::size_t i = 0; i + 1 < legs.size(); ++i) {
    const Vec2& next = legs[i + 1].direction;
    legs[i].turn_rad = std::atan2(cross(legs[i].direction, next), legs[i].direction.dot(next));
  }
  return legs;
}

}  // namespace regista
