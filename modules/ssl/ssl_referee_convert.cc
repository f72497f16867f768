#include "modules/ssl/ssl_referee_convert.h"

#include "modules/convert/common.h"
#include "ssl_referee.pb.h"

namespace regista {
namespace {

constexpr double kMillimetresPerMetre = 1e3;

NamedCommand command_of(::Referee::Command command) {
  using League = ::Referee;
  switch (command) {
    case League::HALT:
      return {GameCommand::halt, {}};
    case League::STOP:
      return {GameCommand::stop, {}};
    case League::NORMAL_START:
      return {GameCommand::normal_start, {}};
    case League::FORCE_START:
      return {GameCommand::force_start, {}};
    case League::PREPARE_KICKOFF_YELLOW:
      return {GameCommand::kick_off, Team::yellow};
    case League::PREPARE_KICKOFF_BLUE:
      return {GameCommand::kick_off, Team::blue};
    case League::PREPARE_PENALTY_YELLOW:
      return {GameCommand::penalty, Team::yellow};
    case League::PREPARE_PENALTY_BLUE:
      return {GameCommand::penalty, Team::blue};
    case League::DIRECT_FREE_YELLOW:
      return {GameCommand::direct_free_kick, Team::yellow};
    case League::DIRECT_FREE_BLUE:
      return {GameCommand::direct_free_kick, Team::blue};
    case League::INDIRECT_FREE_YELLOW:
      return {GameCommand::indirect_free_kick, Team::yellow};
    case League::INDIRECT_FREE_BLUE:
      return {GameCommand::indirect_free_kick, Team::blue};
    case League::TIMEOUT_YELLOW:
      return {GameCommand::timeout, Team::yellow};
    case League::TIMEOUT_BLUE:
      return {GameCommand::timeout, Team::blue};
    case League::GOAL_YELLOW:
      return {GameCommand::goal, Team::yellow};
    case League::GOAL_BLUE:
      return {GameCommand::goal, Team::blue};
    case League::BALL_PLACEMENT_YELLOW:
      return {GameCommand::ball_placement, Team::yellow};
    case League::BALL_PLACEMENT_BLUE:
      return {GameCommand::ball_placement, Team::blue};
  }
  refuse("command is " + std::to_string(command));
}

Time to_time(std::uint64_t stamp_us, const char* field) {
  require(stamp_us <= static_cast<std::uint64_t>(kLatestStamp_us), field, " is ", stamp_us, " us");
  return from_us(static_cast<std::int64_t>(stamp_us));
}

std::uint32_t count(std::uint32_t value, const char* field) {
  require(value <= static_cast<std::uint32_t>(std::numeric_limits<std::int32_t>::max()), field, " is ", value);
  return value;
}

TeamRecord to_record(const ::Referee::TeamInfo& team) {
  require(team.goalkeeper() <= std::numeric_limits<std::uint16_t>::max(), "goalkeeper is ", team.goalkeeper());
  return {static_cast<std::uint16_t>(team.goalkeeper()), count(team.score(), "score"),
          count(team.yellow_cards(), "yellow_cards"), count(team.red_cards(), "red_cards")};
}

}  // namespace

GameState to_game_state(const ::Referee& referee) {
  GameState game;
  game.sent = to_time(referee.packet_timestamp(), "packet_timestamp");
  game.stage = static_cast<GameStage>(referee.stage());
  const NamedCommand named = command_of(referee.command());
  game.command = named.command;
  game.team = named.team;
  game.command_counter = referee.command_counter();
  game.commanded = to_time(referee.command_timestamp(), "command_timestamp");
  if (referee.has_designated_position()) {
    const ::Referee::Point& place = referee.designated_position();
    game.placement_m =
        position_from(double{place.x()} / kMillimetresPerMetre, double{place.y()} / kMillimetresPerMetre);
  }
  game.yellow = to_record(referee.yellow());
  game.blue = to_record(referee.blue());
  return game;
}

}  // namespace regista
