// How near motions come to each other and to shapes, for the tests of control/safety: by halving time until the chord
// of what is left is the curve. Nothing of it is shared with control/safety/separation.h.
#pragma once

#include <limits>

#include "control/safety/motion.h"
#include "planning/obstacle.h"

namespace regista::testing {

/// Least distance of two points whose difference is that of `relative` during its first length_s, to 0.1 nm; `cap_m`
/// where it is larger, which saves time.
double least_distance(const Phase& relative, double length_s, double cap_m);

/// Least distance between the centres of two motions that come to rest, for ever; otherwise likewise.
double least_distance(const Motion& a, const Motion& b, double cap_m = std::numeric_limits<double>::infinity());

/// The same for the clearance of a motion that comes to rest from a shape.
double least_clearance(const Motion& motion, const Obstacle& shape,
                       double cap_m = std::numeric_limits<double>::infinity());

/// Largest |coordinate| by axis during the first length_s of a phase, exactly.
Vec2 furthest(const Phase& phase, double length_s);
Vec2 furthest(const Motion& motion);

}  // namespace regista::testing
