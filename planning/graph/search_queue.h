// What a search looks at next, least estimate first: a few in no order, as most searches have them, more as a
// heap.
#pragma once

#include <cstdint>
#include <vector>

namespace regista::graph {

/// Who finds a better estimate for what is queued queues it again, unless it is better by less. Metres.
inline constexpr double kPutOff_m = 1e-9;

class SearchQueue {
 public:
  struct Entry {
    double estimate_m;    ///< no way that goes on from here is shorter
    std::uint32_t index;  ///< of what is queued
    bool is_arrival;      ///< an arrival whose departures have not all been made; else a leg
  };

  void clear() {
    entries_.clear();
    is_heap_ = false;
  }
  bool is_empty() const { return entries_.empty(); }
  void push(const Entry& entry);

  /// Of equal estimates legs first, then the lesser index. The queue must not be empty.
  Entry pop();

 private:
  std::size_t first_of_few() const;

  std::vector<Entry> entries_;
  bool is_heap_ = false;
};

}  // namespace regista::graph
