// Do two motions keep a distance, does one keep off a shape: answered in continuous time, without steps and without
// roots of quartics.
//
// With n the unit vector between the two at some moment, n·(d + w·t + b·t²/2) never exceeds their distance later, and
// falls to the wanted one at the root of a quadratic. Until that root nothing can happen; there n is taken anew. Ends
// at a proof for the rest of the time, or converges on the contact.
#pragma once

#include <limits>

#include "control/safety/motion.h"
#include "planning/obstacle.h"

namespace regista {

/// What two motions must keep between their centres from now on: distance_m, growing by growth_mps with time.
struct Gap {
  double distance_m = 0.0;
  double growth_mps = 0.0;
};

/// For ever, as the end of a span of time.
inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// Seconds until a point at apart_m that keeps velocity_mps comes within gap_m of the origin: 0 where it is within and
/// comes nearer, infinite where it never does.
double time_to_disc(const Vec2& apart_m, const Vec2& velocity_mps, double gap_m);

/// Two that are already nearer than wanted_m must at least come no nearer: the distance that can be asked of them.
double attainable_gap(double wanted_m, const Motion& a, const Motion& b);

/// True when the centres never come nearer than the gap during [0, until_s]. Motions that come to rest may be asked
/// about for ever (infinite until_s) if the gap does not grow. At the start the gap must not be undercut: false there.
bool keep_apart(const Motion& a, const Motion& b, const Gap& gap, double until_s);

/// Seconds until they come nearer than the gap, likewise; infinite where they keep apart.
double time_to_contact(const Motion& a, const Motion& b, const Gap& gap, double until_s);

/// True when the moving point never comes nearer to the core of the shape (its point, segment or rectangle) than
/// distance_m >= 0, for ever; the motion must come to rest. A start that is nearer: false; on the core likewise.
bool keeps_off(const Motion& motion, const Obstacle& shape, double distance_m);

/// True when the moving point never leaves |x| <= half_extent.x, |y| <= half_extent.y; the motion must come to rest.
bool keeps_inside(const Motion& motion, const Vec2& half_extent_m);

}  // namespace regista
