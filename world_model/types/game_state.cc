#include "world_model/types/game_state.h"

#include <array>

namespace regista {
namespace {

constexpr std::array<const char*, 11> kNames{"halt",     "stop",    "normal_start",     "force_start",
                                             "kick_off", "penalty", "direct_free_kick", "indirect_free_kick",
                                             "timeout",  "goal",    "ball_placement"};

std::vector<NamedCommand> all_commands() {
  std::vector<NamedCommand> all;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const auto command = static_cast<GameCommand>(i);
    if (!is_of_a_team(command)) {
      all.push_back({command, std::nullopt});
      continue;
    }
    for (const Team team : {Team::yellow, Team::blue}) all.push_back({command, team});
  }
  return all;
}

}  // namespace

std::string command_text(GameCommand command, std::optional<Team> team) {
  const std::string base = kNames.at(static_cast<std::size_t>(command));
  return team ? base + "_" + name(*team) : base;
}

std::optional<NamedCommand> parse_command(std::string_view text) {
  for (const NamedCommand& known : all_commands()) {
    if (command_text(known.command, known.team) == text) return known;
  }
  return std::nullopt;
}

std::vector<std::string> command_texts() {
  std::vector<std::string> texts;
  for (const NamedCommand& known : all_commands()) texts.push_back(command_text(known.command, known.team));
  return texts;
}

}  // namespace regista
