// COMMANDS: commands_t.
#pragma once

#include "control/velocity_command.h"
#include "modules/convert/message.h"
#include "regista/commands_t.hpp"

namespace regista {

template <>
struct MessageOf<TeamCommands> {
  using Message = commands_t;
  static constexpr std::array<std::size_t, 1> kElementBytes{74};
  static Message to_message(const TeamCommands& commands);
  static TeamCommands from_message(const Message& message);
};

}  // namespace regista
