// Time as the whole system counts it: whole microseconds, one strong type for instants and one for durations.
#pragma once

#include <chrono>
#include <cstdint>

namespace regista {

/// The clock every stamp belongs to. It has no now(): instants are arguments, only modules/ reads real clocks.
struct FieldClock {
  using duration = std::chrono::microseconds;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<FieldClock>;
  static constexpr bool is_steady = false;
};

using Duration = FieldClock::duration;
using Time = FieldClock::time_point;

constexpr double to_seconds(Duration duration) { return static_cast<double>(duration.count()) * 1e-6; }

/// Rounds to the nearest microsecond; |seconds| must stay below 9·10¹² s.
constexpr Duration from_seconds(double seconds) {
  return Duration{static_cast<std::int64_t>(seconds * 1e6 + (seconds < 0.0 ? -0.5 : 0.5))};
}

constexpr std::int64_t to_us(Time time) { return time.time_since_epoch().count(); }
constexpr Time from_us(std::int64_t stamp_us) { return Time{Duration{stamp_us}}; }

}  // namespace regista
