// A sample in a few numbers, as tables and box plots tell it.
#pragma once

#include <cstddef>
#include <vector>

namespace regista::bench {

/// Percentiles by nearest rank, so each is a measured value. All 0 where there were none.
struct Summary {
  std::size_t count = 0;     ///< of values; failures are apart
  std::size_t failures = 0;  ///< tries that gave no value
  double mean = 0.0;
  double sigma = 0.0;  ///< of the sample, n - 1; 0 for fewer than two values
  double min = 0.0;
  double p25 = 0.0;
  double p50 = 0.0;
  double p75 = 0.0;
  double p90 = 0.0;
  double p99 = 0.0;
  double max = 0.0;

  /// Values among all tries, 0 … 1; 0 where there were none.
  double success() const;
};

/// The values may come in any order.
Summary summarise(std::vector<double> values, std::size_t failures = 0);

}  // namespace regista::bench
