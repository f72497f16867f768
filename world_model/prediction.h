// States at a later time: for the world model and its filters, which ask what will be when a command sent now acts.
#pragma once

#include <span>

#include "world_model/types/body_velocity.h"
#include "world_model/types/world_state.h"

namespace regista {

/// The robot under the commands it was sent, from state_time to until. A command sent from data captured at s acts
/// after s + latency, until the next one acts, and is followed with a first-order lag: v' = (u − v) / velocity_lag_s,
/// where u is the command turned by the predicted heading; a lag of 0 means v = u at once. Before the first command
/// acts velocity and rate are constant. Headings are exact; positions are exact while the rate is constant, else the
/// heading within a step is known to 10⁻⁴ rad. Variances and age stay: the estimate alone knows how they grow. `sent`
/// is sorted by capture time; of equal ones the last counts. Throws std::invalid_argument where it is not, where until
/// < state_time, or where velocity_lag_s is negative or not finite.
RobotState predicted(const RobotState& robot, Time state_time, Time until, std::span<const SentVelocity> sent,
                     Duration latency, double velocity_lag_s);

/// The ball after rolling straight on for `ahead` >= 0, slowing by deceleration_mps2 >= 0 until it rests. Variances and
/// age stay. Throws std::invalid_argument on negative arguments.
BallState predicted(const BallState& ball, Duration ahead, double deceleration_mps2);

}  // namespace regista
