// Beyond these a number is no measurement but an error on its way here. Message converters refuse them and the cores
// throw on them: one list, so that whatever was decoded is accepted by every core.
#pragma once

#include <cmath>
#include <cstdint>

namespace regista {

inline constexpr double kFarthest_m = 1e3;   ///< from the field's centre, per axis
inline constexpr double kFastest_mps = 1e3;  ///< per axis
inline constexpr double kFastestTurn_radps = 1e3;
inline constexpr std::int64_t kLatestStamp_us = std::int64_t{1} << 60;  ///< ± 36,500 years: differences fit 64 bits

/// True for a finite value of at most that size.
inline bool is_plausible(double value, double largest) { return std::isfinite(value) && std::abs(value) <= largest; }

}  // namespace regista
