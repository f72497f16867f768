// Time-optimal motion along one dimension, from which the follower and the heading controller take their speeds:
// speed up at a constant acceleration, cruise at the limit, slow down at a constant deceleration (trapezoid in speed).
//
// Derivation: between two stages of constant acceleration c, v1² = v0² + 2·c·distance and v1 = v0 + c·time. The fastest
// admissible motion has at every place the largest speed from which all limits ahead can still be met.
#pragma once

namespace regista {

/// The largest speed (m/s, or rad/s for angles) from which slowing down at `braking` reaches `end_speed` within
/// `distance`: √(end_speed² + 2·braking·distance). All arguments >= 0.
double speed_before(double distance, double end_speed, double braking);

/// Seconds a trapezoid takes over `distance` >= 0 from start_speed to end_speed, never above speed_max. Needs both
/// speeds in [0, speed_max], positive acceleration and braking, and speeds that can be joined within the distance;
/// throws std::invalid_argument with the values where not.
double trapezoid_duration(double distance, double start_speed, double end_speed, double speed_max, double acceleration,
                          double braking);

/// The speed to hold for the next dt_s so that the motion ends at rest after `distance` >= 0 without passing it, when
/// speeds change in steps of dt_s. Far away it brakes at `braking`; near, where noise would make that chatter, it
/// approaches exponentially with settle_time_s. Zero where distance is zero.
double approach_speed(double distance, double braking, double settle_time_s, double dt_s);

}  // namespace regista
