// The parts that several messages share: teams, robot numbers, points, stamps.
#pragma once

#include <algorithm>
#include <string>

#include "modules/convert/message.h"
#include "regista/point_t.hpp"
#include "world_model/types/geometry.h"
#include "world_model/types/plausible.h"
#include "world_model/types/robot_id.h"
#include "world_model/types/time.h"

namespace regista {

inline std::int8_t team_code(Team team) { return team == Team::yellow ? 0 : 1; }

inline Team team_from(std::int8_t code) {
  require(code == 0 || code == 1, "team is ", code, ", must be 0 or 1");
  return code == 0 ? Team::yellow : Team::blue;
}

inline std::int16_t number_code(std::uint16_t number) { return static_cast<std::int16_t>(number); }
inline std::uint16_t number_from(std::int16_t code) { return static_cast<std::uint16_t>(code); }

inline std::int64_t sequence_code(std::uint64_t sequence) { return static_cast<std::int64_t>(sequence); }

inline std::uint64_t sequence_from(std::int64_t code) {
  require(code >= 0, "sequence is ", code);
  return static_cast<std::uint64_t>(code);
}

inline double plausible(double value, double largest, const char* field) {
  require(is_plausible(value, largest), field, " is ", value, ", beyond ±", largest);
  return value;
}

inline Vec2 position_from(double x_m, double y_m) {
  return {plausible(x_m, kFarthest_m, "x_m"), plausible(y_m, kFarthest_m, "y_m")};
}

inline Vec2 velocity_from(double x_mps, double y_mps) {
  return {plausible(x_mps, kFastest_mps, "velocity along x"), plausible(y_mps, kFastest_mps, "velocity along y")};
}

inline double turn_from(double angular_radps) { return plausible(angular_radps, kFastestTurn_radps, "angular_radps"); }

/// 0–1; some sources report more, which counts as 1.
inline double confidence_from(double confidence) { return std::min(at_least(confidence, 0.0, "confidence"), 1.0); }

inline Pose pose_from(double x_m, double y_m, double heading_rad) {
  constexpr double kMostTurns_rad = 100.0;  // a source may count turns, but not for ever
  return {position_from(x_m, y_m), wrap_angle(plausible(heading_rad, kMostTurns_rad, "heading_rad"))};
}

/// A text with a zero byte in it would not survive the next encoding.
inline std::string text_from(const std::string& text, const char* field) {
  require(text.find('\0') == std::string::npos, field, " holds a zero byte");
  return text;
}

inline point_t to_point(const Vec2& p) { return {p.x(), p.y()}; }

inline Time time_from(std::int64_t stamp_us) {
  require(stamp_us >= -kLatestStamp_us && stamp_us <= kLatestStamp_us, "stamp is ", stamp_us, " us");
  return from_us(stamp_us);
}

inline Duration age_from(std::int64_t age_us) {
  require(age_us >= 0 && age_us <= kLatestStamp_us, "age_us is ", age_us);
  return Duration{age_us};
}

}  // namespace regista
