// Which seeds a bench of motion draws.
#pragma once

#include <cstdint>

#include "planning/uniform.h"

namespace regista::bench {

/// Parameters are chosen on tuning seeds and reported on others.
enum class SeedSet : std::uint64_t { tuning, reporting };

inline std::uint64_t seed_of(SeedSet set, std::uint64_t seed) { return mixed(seed, static_cast<std::uint64_t>(set)); }

}  // namespace regista::bench
