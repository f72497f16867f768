// Our commands as the league's simulation protocol wants them, and its errors as lines for people.
// Messages: SSL simulation protocol, as in proto/ssl_simulation_*.proto.
#pragma once

#include <string>
#include <vector>

#include "control/velocity_command.h"

class RobotControl;
class RobotControlResponse;

namespace regista {

/// Local velocities: the one kind that every simulator takes. Radians per second of the dribbler become turns per
/// minute; no kick is an absent field. Throws MessageError where a value is not finite or faster than 1 km/s
/// (1,000 rad/s, for turning; 10⁵ rad/s for the dribbler).
::RobotControl to_robot_control(const std::vector<RobotCommand>& commands);

/// "CODE: message" of each error, in order.
std::vector<std::string> error_lines(const ::RobotControlResponse& response);

}  // namespace regista
