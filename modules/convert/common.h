// The parts that several messages share: teams, robot numbers, points, stamps.
#pragma once

#include <string>

#include "modules/convert/message.h"
#include "regista/point_t.hpp"
#include "world_model/types/geometry.h"
#include "world_model/types/robot_id.h"
#include "world_model/types/time.h"

namespace regista {

inline std::int8_t team_code(Team team) { return team == Team::yellow ? 0 : 1; }

inline Team team_from(std::int8_t code) {
  require(code == 0 || code == 1, "team is " + std::to_string(code) + ", must be 0 or 1");
  return code == 0 ? Team::yellow : Team::blue;
}

inline std::int16_t number_code(std::uint16_t number) { return static_cast<std::int16_t>(number); }
inline std::uint16_t number_from(std::int16_t code) { return static_cast<std::uint16_t>(code); }

inline std::int64_t sequence_code(std::uint64_t sequence) { return static_cast<std::int64_t>(sequence); }

inline std::uint64_t sequence_from(std::int64_t code) {
  require(code >= 0, "sequence is " + std::to_string(code));
  return static_cast<std::uint64_t>(code);
}

/// Positions and speeds beyond these are no robot's: a hostile or foreign message (metres, metres per second).
inline constexpr double kFarthest_m = 1e4;
inline constexpr double kFastest_mps = 1e3;

inline Vec2 position_from(double x_m, double y_m) {
  require(std::abs(finite(x_m, "x_m")) <= kFarthest_m && std::abs(finite(y_m, "y_m")) <= kFarthest_m,
          "position " + std::to_string(x_m) + ", " + std::to_string(y_m) + " is farther than 10 km");
  return {x_m, y_m};
}

inline Vec2 velocity_from(double vx_mps, double vy_mps) {
  require(std::abs(finite(vx_mps, "vx_mps")) <= kFastest_mps && std::abs(finite(vy_mps, "vy_mps")) <= kFastest_mps,
          "velocity " + std::to_string(vx_mps) + ", " + std::to_string(vy_mps) + " is faster than 1 km/s");
  return {vx_mps, vy_mps};
}

inline Pose pose_from(double x_m, double y_m, double heading_rad) {
  require(std::abs(finite(heading_rad, "heading_rad")) <= 1e3, "heading_rad is " + std::to_string(heading_rad));
  return {position_from(x_m, y_m), wrap_angle(heading_rad)};
}

/// A text with a zero byte in it would not survive the next encoding.
inline std::string text_from(const std::string& text, const char* field) {
  require(text.find('\0') == std::string::npos, std::string(field) + " holds a zero byte");
  return text;
}

inline point_t to_point(const Vec2& p) { return {p.x(), p.y()}; }

/// Stamps within ±285,000 years, so that differences cannot overflow.
inline Time time_from(std::int64_t stamp_us) {
  constexpr std::int64_t kLimit_us = std::int64_t{1} << 62;
  require(stamp_us >= -kLimit_us && stamp_us <= kLimit_us, "stamp_us is " + std::to_string(stamp_us));
  return from_us(stamp_us);
}

}  // namespace regista
