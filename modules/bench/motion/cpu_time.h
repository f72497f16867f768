// The time single shots take on their core: what other programs take of it meanwhile, and while several games are
// played at once there are some, does not count.
#pragma once

#include <ctime>

namespace regista::bench {

/// Runs from its making on; to be read on the thread that made it.
class CpuShot {
 public:
  double us() const { return now_us() - began_us_; }
  double s() const { return us() * 1e-6; }

 private:
  static double now_us() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e6 + static_cast<double>(time.tv_nsec) * 1e-3;
  }
  double began_us_ = now_us();
};

}  // namespace regista::bench
