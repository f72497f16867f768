// The time of single shots.
#pragma once

#include <chrono>

namespace regista::bench {

/// Runs from its making on, on the steady clock. Reading it costs some 20 ns; nothing is subtracted for that.
class SingleShot {
 public:
  using Clock = std::chrono::steady_clock;

  double us() const { return std::chrono::duration<double, std::micro>(Clock::now() - began_).count(); }
  double s() const { return us() * 1e-6; }

 private:
  Clock::time_point began_ = Clock::now();
};

}  // namespace regista::bench
