#include "modules/process/percentiles.h"

#include <algorithm>
#include <cmath>

namespace regista {

Percentiles percentiles(std::vector<std::int64_t> times_ns) {
  if (times_ns.empty()) return {};
  std::sort(times_ns.begin(), times_ns.end());
  const auto at = [&](double share) {
    return times_ns[static_cast<std::size_t>(std::lround(share * static_cast<double>(times_ns.size() - 1)))];
  };
  return {at(0.50), at(0.99), at(1.0), times_ns.size()};
}

}  // namespace regista
