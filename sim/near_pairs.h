// Finds the robots that are near each other, by sort and sweep along x. The order is kept from step to step, so that
// sorting costs next to nothing while robots move by millimetres.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/robot_model.h"

namespace regista {

/// Two indices into the simulator's robots, first < second.
struct IndexPair {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  bool operator==(const IndexPair&) const = default;
  bool operator<(const IndexPair& other) const {
    return first != other.first ? first < other.first : second < other.second;
  }
};

class NearPairs {
 public:
  /// All pairs whose centres are at most distance_m apart, sorted; valid until the next call.
  const std::vector<IndexPair>& find(const std::vector<RobotBody>& robots, double distance_m);

 private:
  struct Entry {
    double x;
    double y;
    std::uint32_t robot;
  };
  void sort(const std::vector<RobotBody>& robots);

  std::vector<Entry> order_;  // by x
  std::vector<IndexPair> pairs_;
};

}  // namespace regista
