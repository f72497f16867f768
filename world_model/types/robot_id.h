// Who a robot is: its team's colour and its number on the pattern.
#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace regista {

enum class Team : std::uint8_t { yellow, blue };

constexpr Team opponent_of(Team team) { return team == Team::yellow ? Team::blue : Team::yellow; }
constexpr char letter(Team team) { return team == Team::yellow ? 'Y' : 'B'; }
constexpr const char* name(Team team) { return team == Team::yellow ? "yellow" : "blue"; }

struct RobotId {
  Team team = Team::yellow;
  std::uint16_t number = 0;  ///< 0–15 in the SSL; fleets may count to 65535
  auto operator<=>(const RobotId&) const = default;
};

/// "Y3", "B11": as channels, tables and pictures write it.
inline std::string to_string(RobotId id) { return letter(id.team) + std::to_string(id.number); }

}  // namespace regista
