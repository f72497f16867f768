#include "modules/process/real_clock.h"

namespace regista {

Clock real_clock() {
  using std::chrono::steady_clock;
  using std::chrono::system_clock;
  const auto start = std::chrono::duration_cast<Duration>(system_clock::now().time_since_epoch());
  const auto steady_start = steady_clock::now();
  return [start, steady_start] {
    return Time{start + std::chrono::duration_cast<Duration>(steady_clock::now() - steady_start)};
  };
}

Stopwatch real_stopwatch() {
  return [] {
    const auto since = std::chrono::steady_clock::now().time_since_epoch();
    return std::int64_t{std::chrono::duration_cast<std::chrono::nanoseconds>(since).count()};
  };
}

}  // namespace regista
