// What the referee's command means for motion right now: commands come once, but a free kick restricts robots only
// until the ball is in play. For planning and control, which both keep a watch of their own.
#pragma once

#include <cstdint>
#include <optional>

#include "world_model/types/game_state.h"
#include "world_model/types/world_state.h"

namespace regista {

enum class SituationKind : std::uint8_t { running, halt, stop, kick_off, free_kick, penalty, ball_placement };

/// The default is play without a referee: nothing is restricted.
struct Situation {
  SituationKind kind = SituationKind::running;
  std::optional<Team> team;         ///< who takes the kick or places the ball; nobody where it is no team's
  std::optional<Vec2> placement_m;  ///< where the ball is to be placed
  bool operator==(const Situation&) const = default;
};

/// The ball is in play when it has moved this far (SSL rules, "Ball in and out of play"). Metres.
inline constexpr double kInPlay_m = 0.05;
/// Or after this time (the same: 10 s in division B, 5 s in A; the longer binds nobody wrongly to less distance).
inline constexpr Duration kInPlayAfter{10'000'000};

class SituationWatch {
 public:
  /// What holds in that world; game is the newest word of the referee, nullptr where none was ever heard. Worlds come
  /// in the order of their time. A watch that begins amid play takes the command for just given.
  Situation update(const GameState* game, const WorldState& world);

 private:
  void begin(const GameState& game, const WorldState& world);
  bool in_play(const WorldState& world);

  std::optional<std::uint32_t> counter_;  // of the command watched
  GameCommand command_ = GameCommand::halt;
  Situation situation_;
  bool may_be_taken_ = false;  // the ball comes into play when it moves
  bool is_in_play_ = false;
  Time since_{};
  std::optional<Vec2> ball_m_;  // when the kick could first be taken
};

}  // namespace regista
