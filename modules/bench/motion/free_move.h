// A robot alone, without noise or delay, driven by the system from any state to rest at a point, for the bench of free
// motion.
#pragma once

#include <optional>

#include "modules/bench/motion/loop_config.h"

namespace regista::bench {

struct FreeState {
  Vec2 position_m = Vec2::Zero();  ///< the target is the origin
  Vec2 velocity_mps = Vec2::Zero();
};

struct FreeMove {
  std::optional<double> arrived_s;  ///< within kThere_m and kSlow_mps; none: not within kFreeLimit_s
  FreeState then;
};

inline constexpr double kThere_m = 0.01;
inline constexpr double kSlow_mps = 0.3;  ///< 1 cm at 4 m/s² stops 0.28 m/s
inline constexpr double kFreeLimit_s = 20.0;

/// The body follows commands at once, in steps of a millisecond, within the limits of params.control; vision is exact
/// at 100 Hz. Headings stay.
FreeMove drive_freely(const FreeState& from, const SystemParams& params);

/// The system's parameters for moves without a limit of speed: as chosen, with these limits. Throws ConfigError.
SystemParams free_params(const SystemChoice& choice, double acceleration_mps2, double braking_mps2);

}  // namespace regista::bench
