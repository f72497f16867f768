// With whose lengths a bench compares.
#pragma once

#include "modules/bench/contender.h"

namespace regista::bench {

/// The exact planner `tangent`; where the registry has none, visibility_sampling.
inline const char* reference_planner() { return is_registered("tangent") ? "tangent" : "visibility_sampling"; }

/// More samples than any planner draws in the times benches allow, so that time alone is the limit.
inline constexpr std::int64_t kUnlimitedIterations = 100'000;

}  // namespace regista::bench
