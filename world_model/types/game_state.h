// What the referee says: stage, command, placement, cards and scores. State, not event: the newest is all one needs.
// Source: the league's Referee message (stages, commands) and SSL rules, "Referee commands".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "world_model/types/geometry.h"
#include "world_model/types/robot_id.h"
#include "world_model/types/time.h"

namespace regista {

/// In the order of the league's message; "pre": teams get ready, the half has not begun.
enum class GameStage : std::uint8_t {
  first_half_pre,
  first_half,
  half_time,
  second_half_pre,
  second_half,
  extra_time_break,
  extra_first_half_pre,
  extra_first_half,
  extra_half_time,
  extra_second_half_pre,
  extra_second_half,
  shootout_break,
  shootout,
  post_game,
};

/// From kick_off on a command belongs to one team. kick_off and penalty only prepare: normal_start lets them be taken.
enum class GameCommand : std::uint8_t {
  halt,
  stop,
  normal_start,
  force_start,
  kick_off,
  penalty,
  direct_free_kick,
  indirect_free_kick,
  timeout,
  goal,
  ball_placement,
};

constexpr bool is_of_a_team(GameCommand command) { return command >= GameCommand::kick_off; }

struct TeamRecord {
  std::uint16_t goalkeeper = 0;  ///< robot number
  std::uint32_t score = 0;
  std::uint32_t yellow_cards = 0;  ///< in force now
  std::uint32_t red_cards = 0;
  bool operator==(const TeamRecord&) const = default;
};

struct GameState {
  Time sent{};  ///< on the referee's clock
  GameStage stage = GameStage::first_half;
  GameCommand command = GameCommand::halt;
  std::optional<Team> team;           ///< whose command it is; set exactly when is_of_a_team(command)
  std::uint32_t command_counter = 0;  ///< changes with every command, also when the same comes again
  Time commanded{};                   ///< when the command was given, on the referee's clock
  std::optional<Vec2> placement_m;    ///< where the ball is to be placed
  TeamRecord yellow;
  TeamRecord blue;
  bool operator==(const GameState&) const = default;
};

/// "stop", "kick_off_yellow": command and team in one word, as people and scenarios write it.
std::string command_text(GameCommand command, std::optional<Team> team);

struct NamedCommand {
  GameCommand command = GameCommand::halt;
  std::optional<Team> team;
  bool operator==(const NamedCommand&) const = default;
};

/// The inverse of command_text; nothing for any other text.
std::optional<NamedCommand> parse_command(std::string_view text);

/// All texts that parse, in the order of the enumeration, yellow before blue.
std::vector<std::string> command_texts();

}  // namespace regista
