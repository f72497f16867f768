// REFEREE: referee_t.
#pragma once

#include "modules/convert/message.h"
#include "regista/referee_t.hpp"
#include "world_model/types/game_state.h"

namespace regista {

template <>
struct MessageOf<GameState> {
  using Message = referee_t;
  static constexpr std::array<std::size_t, 0> kElementBytes{};
  static Message to_message(const GameState& game);
  static GameState from_message(const Message& message);
};

}  // namespace regista
