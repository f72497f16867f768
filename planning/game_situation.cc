#include "planning/game_situation.h"

namespace regista {
namespace {

/// What the command alone says.
Situation commanded(const GameState& game) {
  switch (game.command) {
    case GameCommand::halt:
      return {SituationKind::halt, {}, {}};
    case GameCommand::stop:
    case GameCommand::timeout:  // robots may be moved, play goes on with a stop
    case GameCommand::goal:     // no longer sent by the league; a stop follows
      return {SituationKind::stop, {}, {}};
    case GameCommand::normal_start:
    case GameCommand::force_start:
      return {};
    case GameCommand::kick_off:
      return {SituationKind::kick_off, game.team, {}};
    case GameCommand::penalty:
      return {SituationKind::penalty, game.team, {}};
    case GameCommand::direct_free_kick:
    case GameCommand::indirect_free_kick:
      return {SituationKind::free_kick, game.team, {}};
    case GameCommand::ball_placement:
      return {SituationKind::ball_placement, game.team, game.placement_m};
  }
  return {SituationKind::halt, {}, {}};
}

bool is_prepared(SituationKind kind) { return kind == SituationKind::kick_off || kind == SituationKind::penalty; }

}  // namespace

Situation SituationWatch::update(const GameState* game, const WorldState& world) {
  if (game == nullptr) return {};
  if (game->command_counter != counter_ || game->command != command_) begin(*game, world);
  if (situation_.kind == SituationKind::ball_placement) situation_.placement_m = game->placement_m;
  return may_be_taken_ && in_play(world) ? Situation{} : situation_;
}

void SituationWatch::begin(const GameState& game, const WorldState& world) {
  // A normal start lets the kick be taken that was prepared before; until then nothing else changes.
  const bool lets_take = game.command == GameCommand::normal_start && is_prepared(situation_.kind) && !may_be_taken_;
  if (!lets_take) situation_ = commanded(game);
  may_be_taken_ = lets_take || situation_.kind == SituationKind::free_kick;
  is_in_play_ = false;
  counter_ = game.command_counter;
  command_ = game.command;
  since_ = world.captured;
  ball_m_.reset();
}

bool SituationWatch::in_play(const WorldState& world) {
  if (world.captured < since_) since_ = world.captured;  // the clock of vision was set anew
  if (!ball_m_ && world.ball) ball_m_ = world.ball->position_m;
  const bool moved = ball_m_ && world.ball && (world.ball->position_m - *ball_m_).norm() > kInPlay_m;
  is_in_play_ = is_in_play_ || moved || world.captured - since_ > kInPlayAfter;
  return is_in_play_;
}

}  // namespace regista
