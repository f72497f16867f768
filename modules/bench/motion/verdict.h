// What a bench's checker says of a closed loop.
#pragma once

#include "modules/bench/checker.h"
#include "modules/bench/motion/closed_loop.h"

namespace regista::bench {

/// Every tick counts as an answer, every violation as a fault of `who`.
inline void check(Checker& checker, const std::string& who, const LoopVerdict& verdict) {
  checker.add_checked(verdict.ticks);
  for (const Violation& violation : verdict.violations) checker.add_fault(who, to_string(violation));
}

}  // namespace regista::bench
