#include "modules/convert/referee.h"

#include "modules/convert/common.h"

namespace regista {
namespace {

constexpr std::int8_t kNobody = -1;

std::uint32_t count_from(std::int64_t count, const char* field) {
  require(count >= 0 && count <= std::numeric_limits<std::uint32_t>::max(), field, " is ", count);
  return static_cast<std::uint32_t>(count);
}

referee_team_t to_message(const TeamRecord& record) {
  return {number_code(record.goalkeeper), static_cast<std::int32_t>(record.score),
          static_cast<std::int32_t>(record.yellow_cards), static_cast<std::int32_t>(record.red_cards)};
}

TeamRecord from_message(const referee_team_t& message) {
  return {number_from(message.goalkeeper), count_from(message.score, "score"),
          count_from(message.yellow_cards, "yellow_cards"), count_from(message.red_cards, "red_cards")};
}

}  // namespace

referee_t MessageOf<GameState>::to_message(const GameState& game) {
  referee_t message{};
  message.stamp_us = to_us(game.sent);
  message.stage = static_cast<std::int8_t>(game.stage);
  message.command = static_cast<std::int8_t>(game.command);
  message.command_team = game.team ? team_code(*game.team) : kNobody;
  message.command_counter = game.command_counter;
  message.command_stamp_us = to_us(game.commanded);
  message.has_placement = game.placement_m ? 1 : 0;
  if (game.placement_m) {
    message.placement_x_m = game.placement_m->x();
    message.placement_y_m = game.placement_m->y();
  }
  message.yellow = regista::to_message(game.yellow);
  message.blue = regista::to_message(game.blue);
  return message;
}

GameState MessageOf<GameState>::from_message(const referee_t& message) {
  GameState game;
  game.sent = time_from(message.stamp_us);
  require(message.stage >= 0 && message.stage <= static_cast<int>(GameStage::post_game), "stage is ", message.stage);
  game.stage = static_cast<GameStage>(message.stage);
  require(message.command >= 0 && message.command <= static_cast<int>(GameCommand::ball_placement), "command is ",
          message.command);
  game.command = static_cast<GameCommand>(message.command);
  require((message.command_team != kNobody) == is_of_a_team(game.command), "command ", message.command,
          " comes with command_team ", message.command_team);
  if (message.command_team != kNobody) game.team = team_from(message.command_team);
  game.command_counter = count_from(message.command_counter, "command_counter");
  game.commanded = time_from(message.command_stamp_us);
  if (message.has_placement != 0) game.placement_m = position_from(message.placement_x_m, message.placement_y_m);
  game.yellow = regista::from_message(message.yellow);
  game.blue = regista::from_message(message.blue);
  return game;
}

template std::vector<std::uint8_t> encode(const GameState&);
template GameState decode(std::span<const std::uint8_t>);

}  // namespace regista
