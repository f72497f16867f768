// Measured times as people are told them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace regista {

/// Single shots, nearest rank; all 0 where there were none.
struct Percentiles {
  std::int64_t p50_ns = 0;
  std::int64_t p99_ns = 0;
  std::int64_t max_ns = 0;
  std::size_t count = 0;
};

/// The times may come in any order.
Percentiles percentiles(std::vector<std::int64_t> times_ns);

}  // namespace regista
