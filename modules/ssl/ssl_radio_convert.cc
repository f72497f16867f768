#include "modules/ssl/ssl_radio_convert.h"

#include <numbers>

#include "modules/convert/common.h"
#include "modules/ssl/packet.h"
#include "ssl_simulation_control.pb.h"
#include "ssl_simulation_response.pb.h"

namespace regista {
namespace {

constexpr double kFastestDribbler_radps = 1e5;  // as far from any motor
constexpr double kRpmPerRadps = 60.0 / (2.0 * std::numbers::pi);

float bounded(double value, double largest, const char* field) {
  require(std::abs(finite(value, field)) <= largest, field, " is ", value);
  return static_cast<float>(value);
}

}  // namespace

::RobotControl to_robot_control(const std::vector<RobotCommand>& commands) {
  ::RobotControl control;
  for (const RobotCommand& command : commands) {
    ::RobotCommand& out = *control.add_robot_commands();
    out.set_id(command.robot);
    MoveLocalVelocity& velocity = *out.mutable_move_command()->mutable_local_velocity();
    velocity.set_forward(bounded(command.velocity.forward_mps, kFastest_mps, "forward_mps"));
    velocity.set_left(bounded(command.velocity.left_mps, kFastest_mps, "left_mps"));
    velocity.set_angular(bounded(command.velocity.angular_radps, kFastestTurn_radps, "angular_radps"));
    const float kick_mps = bounded(command.kick_speed_mps, kFastest_mps, "kick_speed_mps");
    if (kick_mps > 0.0F) out.set_kick_speed(kick_mps);
    const double dribbler_radps = double{bounded(command.dribbler_radps, kFastestDribbler_radps, "dribbler_radps")};
    out.set_dribbler_speed(static_cast<float>(dribbler_radps * kRpmPerRadps));
  }
  return control;
}

std::vector<std::string> error_lines(const ::RobotControlResponse& response) {
  std::vector<std::string> lines;
  for (const SimulatorError& error : response.errors()) {
    const std::string code = error.code().empty() ? "error" : error.code();
    lines.push_back(one_line(error.message().empty() ? code : code + ": " + error.message()));
  }
  return lines;
}

}  // namespace regista
