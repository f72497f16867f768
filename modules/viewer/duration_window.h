// The latest of a stream of durations, and what they come to.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "modules/viewer/viewer_scene.h"

namespace regista {

class DurationWindow {
 public:
  /// capacity > 0; beyond it the oldest is forgotten.
  explicit DurationWindow(std::size_t capacity) : capacity_(capacity) {}

  void add(std::int64_t duration_ns) {
    if (durations_ns_.size() < capacity_) {
      durations_ns_.push_back(duration_ns);
    } else {
      durations_ns_[oldest_] = duration_ns;
      oldest_ = (oldest_ + 1) % capacity_;
    }
  }

  /// nullopt before the first.
  std::optional<DurationSummary> summary() const {
    if (durations_ns_.empty()) return std::nullopt;
    std::vector<std::int64_t> sorted = durations_ns_;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return DurationSummary{*middle, *std::max_element(middle, sorted.end())};
  }

 private:
  std::size_t capacity_;
  std::size_t oldest_ = 0;
  std::vector<std::int64_t> durations_ns_;
};

}  // namespace regista
