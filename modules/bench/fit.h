// Power laws: the slope of a straight line through points on logarithmic axes.
#pragma once

#include <span>

#include "world_model/types/geometry.h"

namespace regista::bench {

struct PowerLaw {
  double factor = 0.0;
  double exponent = 0.0;
};

/// y = factor · x^exponent, least squares of log y over log x. Throws std::invalid_argument for fewer than two places
/// x, or a coordinate that is not positive.
PowerLaw fit_power_law(std::span<const Vec2> points);

}  // namespace regista::bench
