// Writes a closed loop to a log that viewer, spy and `regista log` read: field, truth as the world, targets and plans.
#pragma once

#include <string>

#include "logs/log_writer.h"
#include "modules/bench/motion/closed_loop.h"

namespace regista::bench {

class LoopRecorder {
 public:
  /// Throws LogError.
  LoopRecorder(const std::string& file, const FieldGeometry& field);

  /// The moment of the last tick. Throws LogError.
  void record(const ClosedLoop& loop);
  /// Throws LogError when the file cannot be completed.
  void close() { writer_.close(); }

 private:
  FieldGeometry field_;
  bool announced_ = false;
  LogWriter writer_;
};

}  // namespace regista::bench
