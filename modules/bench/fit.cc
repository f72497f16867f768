#include "modules/bench/fit.h"

#include <stdexcept>

namespace regista::bench {

PowerLaw fit_power_law(std::span<const Vec2> points) {
  const double count = static_cast<double>(points.size());
  Vec2 mean = Vec2::Zero();
  for (const Vec2& point : points) {
    if (!(point.minCoeff() > 0.0)) {
      throw std::invalid_argument("a power law needs positive points, not (" + std::to_string(point.x()) + ", " +
                                  std::to_string(point.y()) + ")");
    }
    mean += Vec2(std::log(point.x()), std::log(point.y())) / count;
  }
  double xx = 0.0;
  double xy = 0.0;
  for (const Vec2& point : points) {
    const double x = std::log(point.x()) - mean.x();
    xx += x * x;
    xy += x * (std::log(point.y()) - mean.y());
  }
  if (!(xx > 0.0)) throw std::invalid_argument("a power law needs points at two places at least");
  const double exponent = xy / xx;
  return {std::exp(mean.y() - exponent * mean.x()), exponent};
}

}  // namespace regista::bench
