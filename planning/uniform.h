// Random numbers that are the same on every machine: std::mt19937_64 is, the standard's distributions are not.
#pragma once

#include <cstdint>
#include <random>

namespace regista {

/// Uniform in [0, 1), from the upper 53 bits.
inline double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1.0p-53; }

inline double uniform(std::mt19937_64& random, double low, double high) { return low + (high - low) * uniform(random); }

/// A seed that depends on all bits of both (splitmix64, Steele, Lea & Flood 2014).
inline std::uint64_t mixed(std::uint64_t seed, std::uint64_t value) {
  std::uint64_t z = seed + 0x9E3779B97F4A7C15ULL * (value + 1);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31);
}

}  // namespace regista
