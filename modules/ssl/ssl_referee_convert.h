// The league's referee message as our game state: its commands split into command and team, millimetres to metres.
// Messages: SSL game controller, as in proto/ssl_referee.proto.
#pragma once

#include "world_model/types/game_state.h"

class Referee;

namespace regista {

/// Stamps stay on the referee's own clock. Throws MessageError where a stamp is beyond ± 36,500 years, the placement
/// not finite or farther than 1 km, a goalkeeper's number beyond 65535, or a count beyond 2³¹ − 1.
GameState to_game_state(const ::Referee& referee);

}  // namespace regista
