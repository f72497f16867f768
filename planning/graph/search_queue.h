// What a tangent search looks at next: a heap, least estimate first.
#pragma once

#include <cstdint>
#include <vector>

namespace regista::graph {

class SearchQueue {
 public:
  struct Entry {
    double estimate_m;    ///< no way that goes on from here is shorter
    std::uint32_t index;  ///< of what is queued
    bool is_arrival;      ///< an arrival whose departures have not all been made; else a leg
  };

  void clear() { heap_.clear(); }
  bool is_empty() const { return heap_.empty(); }
  void push(const Entry& entry);

  /// Of equal estimates legs first, then the lesser index. The queue must not be empty.
  Entry pop();

 private:
  std::vector<Entry> heap_;
};

}  // namespace regista::graph
