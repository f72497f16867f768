// The machine's clocks, for processes only: lock step and replay hand modules their own.
#pragma once

#include <cstdint>

#include "modules/bus/bus.h"

namespace regista {

/// Microseconds since 1970, steady within the process: the system clock at start, then the monotonic one, so that a
/// correction of the system clock cannot make robots stop or deadlines pass.
Clock real_clock();

/// Nanoseconds of a steady clock with an arbitrary origin, for measuring how long things take.
using Stopwatch = std::function<std::int64_t()>;
Stopwatch real_stopwatch();

}  // namespace regista
