// Drives one module in a process of its own: waits for messages, drains them, ticks, and reports STATUS once a second.
#pragma once

#include <vector>

#include "modules/bus/module.h"
#include "modules/process/real_clock.h"

namespace regista {

class ProcessLoop {
 public:
  ProcessLoop(Module& module, Bus& bus, Stopwatch stopwatch);

  /// Waits at most max_wait for a message or for the module's due time, takes everything that has come in (newest
  /// wins), then ticks once if the module is ready or due. Throws what the module or the bus throws.
  void step(Duration max_wait);

 private:
  void report_if_due();
  void report_refusal();

  Module& module_;
  Bus& bus_;
  Stopwatch stopwatch_;
  std::string host_;
  Time started_;
  Time reported_;
  std::vector<std::int64_t> tick_times_ns_;  ///< since the last report
  std::int64_t refusals_logged_ = 0;
  std::int64_t refused_reported_ = 0;
};

}  // namespace regista
