// From the referee's commands to what holds now.
#include "planning/game_situation.h"

#include <catch2/catch.hpp>

namespace regista {
namespace {

struct Game {
  SituationWatch watch;
  GameState game;
  WorldState world;

  Game() { world.ball = BallState{}; }
  Situation at(double seconds) {
    world.captured = Time{} + from_seconds(seconds);
    return watch.update(&game, world);
  }
  Situation say(GameCommand command, std::optional<Team> team = std::nullopt) {
    game.command = command;
    game.team = team;
    ++game.command_counter;
    return watch.update(&game, world);
  }
  void ball_moves(double by_m) { world.ball->position_m.x() += by_m; }
};

TEST_CASE("without a referee play runs") {
  SituationWatch watch;
  CHECK(watch.update(nullptr, {}) == Situation{});
}

TEST_CASE("commands that hold until the next one") {
  Game game;
  CHECK(game.say(GameCommand::halt).kind == SituationKind::halt);
  CHECK(game.say(GameCommand::stop).kind == SituationKind::stop);
  game.ball_moves(1.0);
  CHECK(game.at(100.0).kind == SituationKind::stop);
  CHECK(game.say(GameCommand::timeout, Team::blue).kind == SituationKind::stop);
  CHECK(game.say(GameCommand::force_start) == Situation{});
  CHECK(game.say(GameCommand::normal_start) == Situation{});
}

TEST_CASE("a placement knows its place, also when it is changed") {
  Game game;
  game.game.placement_m = Vec2(1, 2);
  CHECK(game.say(GameCommand::ball_placement, Team::blue) ==
        Situation{SituationKind::ball_placement, Team::blue, Vec2(1, 2)});
  game.game.placement_m = Vec2(3, 2);
  CHECK(game.at(1.0).placement_m == Vec2(3, 2));
}

TEST_CASE("a free kick restricts until the ball has moved, or for ten seconds") {
  for (const GameCommand command : {GameCommand::direct_free_kick, GameCommand::indirect_free_kick}) {
    Game game;
    CHECK(game.say(command, Team::yellow) == Situation{SituationKind::free_kick, Team::yellow, {}});
    game.ball_moves(0.04);
    CHECK(game.at(1.0).kind == SituationKind::free_kick);
    SECTION("moved") {
      game.ball_moves(0.02);
      CHECK(game.at(1.1).kind == SituationKind::running);
      game.ball_moves(-0.06);  // once in play, in play
      CHECK(game.at(1.2).kind == SituationKind::running);
      game.say(command, Team::blue);
      CHECK(game.at(1.3) == Situation{SituationKind::free_kick, Team::blue, {}});
    }
    SECTION("waited") {
      CHECK(game.at(9.9).kind == SituationKind::free_kick);
      CHECK(game.at(10.1).kind == SituationKind::running);
    }
    SECTION("a ball that is out of sight is not in play for it") {
      game.world.ball.reset();
      CHECK(game.at(1.1).kind == SituationKind::free_kick);
    }
    SECTION("a clock set back does not end it") {
      CHECK(game.at(-50.0).kind == SituationKind::free_kick);
      CHECK(game.at(-45.0).kind == SituationKind::free_kick);
      CHECK(game.at(-39.0).kind == SituationKind::running);
    }
  }
}

TEST_CASE("a kick-off is prepared, then taken") {
  Game game;
  game.say(GameCommand::kick_off, Team::blue);
  game.ball_moves(0.5);  // while it is laid in place
  CHECK(game.at(30.0) == Situation{SituationKind::kick_off, Team::blue, {}});
  CHECK(game.say(GameCommand::normal_start) == Situation{SituationKind::kick_off, Team::blue, {}});
  CHECK(game.at(31.0).kind == SituationKind::kick_off);
  game.ball_moves(0.06);
  CHECK(game.at(31.1).kind == SituationKind::running);
  CHECK(game.say(GameCommand::normal_start).kind == SituationKind::running);
  game.say(GameCommand::kick_off, Team::blue);
  CHECK(game.say(GameCommand::force_start).kind == SituationKind::running);
}

}  // namespace
}  // namespace regista
