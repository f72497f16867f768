// The angle between two unit vectors, without atan2: what an arc of a taut path costs.
#pragma once

#include "world_model/types/geometry.h"

namespace regista::graph {

/// A turn backwards by less than this is rounding and counts as none. Radians.
inline constexpr double kNoTurn_rad = 4e-9;

/// How far to turn from one unit vector to the other, counter-clockwise when `side` is 1, clockwise when it is -1;
/// in [0, 2π).
double turn(const Vec2& from, const Vec2& to, double side);

}  // namespace regista::graph
