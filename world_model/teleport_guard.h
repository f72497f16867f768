// Tells a false detection from an object that was put elsewhere: one detection outside the gate is ignored, several in
// a row that agree with each other are believed. For the world model's robots and ball.
#pragma once

#include <cstdint>

#include "world_model/types/geometry.h"
#include "world_model/types/time.h"

namespace regista {

class TeleportGuard {
 public:
  /// A detection inside the gate: whatever lay outside before was false.
  void accepted() { count_ = 0; }

  /// A detection outside the gate. True when it is the `needed`-th in a row (needed >= 1), each within reach_m +
  /// speed_max_mps · time of the one before: start the object anew there. Then the count begins again.
  bool refused(const Vec2& position_m, Time captured, double reach_m, double speed_max_mps, std::int64_t needed) {
    const double apart_s = std::abs(to_seconds(captured - captured_));
    const bool agrees = (position_m - position_m_).norm() <= reach_m + speed_max_mps * apart_s;
    count_ = agrees ? count_ + 1 : 1;
    position_m_ = position_m;
    captured_ = captured;
    if (count_ < needed) return false;
    count_ = 0;
    return true;
  }

 private:
  std::int64_t count_ = 0;
  Vec2 position_m_ = Vec2::Zero();
  Time captured_{};
};

}  // namespace regista
