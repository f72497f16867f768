#include "modules/bench/summary.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace regista::bench {

double Summary::success() const {
  const std::size_t tries = count + failures;
  return tries == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(tries);
}

Summary summarise(std::vector<double> values, std::size_t failures) {
  Summary summary;
  summary.failures = failures;
  summary.count = values.size();
  if (values.empty()) return summary;
  std::sort(values.begin(), values.end());
  const double count = static_cast<double>(values.size());
  summary.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0.0;
  for (const double value : values) squares += (value - summary.mean) * (value - summary.mean);
  summary.sigma = values.size() > 1 ? std::sqrt(squares / (count - 1.0)) : 0.0;
  const auto at = [&](double share) { return values[static_cast<std::size_t>(std::lround(share * (count - 1.0)))]; };
  summary.min = values.front();
  summary.p25 = at(0.25);
  summary.p50 = at(0.50);
  summary.p75 = at(0.75);
  summary.p90 = at(0.90);
  summary.p99 = at(0.99);
  summary.max = values.back();
  return summary;
}

}  // namespace regista::bench
