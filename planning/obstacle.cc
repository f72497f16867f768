#include "planning/obstacle.h"

namespace regista {

bool is_valid(const Obstacle& obstacle) {
  return is_finite(obstacle.a) && is_finite(obstacle.b) && std::isfinite(obstacle.radius_m) && obstacle.radius_m >= 0.0;
}

}  // namespace regista
