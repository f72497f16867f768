// When a module that died is started again, and when that is given up.
#pragma once

#include <optional>

#include "world_model/types/time.h"

namespace regista {

class RestartPolicy {
 public:
  /// At most one start in this time.
  static constexpr Duration kRestartEvery = std::chrono::seconds(1);
  /// Dying sooner than this after the start is quick: longer than any module needs to open its bus and read its file.
  static constexpr Duration kQuickDeath = std::chrono::seconds(5);
  /// So many quick deaths in a row, and the module will not come up by starting it once more.
  static constexpr int kGiveUpAfter = 5;

  void started(Time now) { started_ = now; }

  /// When to start again; nullopt: never.
  std::optional<Time> died(Time now) {
    quick_deaths_ = now - started_ < kQuickDeath ? quick_deaths_ + 1 : 0;
    if (given_up()) return std::nullopt;
    return now - started_ < kRestartEvery ? started_ + kRestartEvery : now;
  }

  bool given_up() const { return quick_deaths_ >= kGiveUpAfter; }

 private:
  Time started_{};
  int quick_deaths_ = 0;  ///< in a row
};

}  // namespace regista
