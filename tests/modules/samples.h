// Random values of every message type, from a seed.
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "modules/bus/channels.h"

namespace samples {

/// Raw bits mapped by hand, so that a seed means the same values everywhere.
class Source {
 public:
  explicit Source(std::uint64_t seed) : bits_(seed) {}
  std::uint64_t below(std::uint64_t limit) { return bits_() % limit; }
  double within(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11U) * 0x1.0p-53;
  }
  bool coin() { return below(2) == 0; }
  std::string word() { return std::string(below(12), static_cast<char>('a' + below(26))); }

 private:
  std::mt19937_64 bits_;
};

/// Lists have at least two elements.
template <class Value>
Value make(Source& source);

}  // namespace samples
