// WORLD_STATE and TRUTH: world_state_t.
#pragma once

#include "modules/convert/message.h"
#include "regista/world_state_t.hpp"
#include "world_model/types/world_state.h"

namespace regista {

template <>
struct MessageOf<WorldState> {
  using Message = world_state_t;
  static constexpr std::array<std::size_t, 2> kElementBytes{83, 56};
  static Message to_message(const WorldState& world);
  static WorldState from_message(const Message& message);
};

}  // namespace regista
