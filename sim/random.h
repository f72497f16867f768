// Seeded random numbers for the simulator, the tasks and their tests. Only the raw bits of std::mt19937_64, which the
// standard fixes, are used; the mappings are our own, because std::*_distribution differs between libraries.
#pragma once

#include <cstdint>
#include <random>

namespace regista {

/// Seed of an independent stream, so that one user of a seed cannot shift the numbers of another (splitmix64's mixing
/// function: Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014).
std::uint64_t derived_seed(std::uint64_t seed, std::uint64_t stream);

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  /// In [0, 1), 53 random bits.
  double uniform();
  /// In [low, high), finite low <= high.
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Mean 0, standard deviation 1 (Box and Muller, 1958).
  double normal();
  /// True with that probability; a number is drawn whatever the probability is.
  bool chance(double probability) { return uniform() < probability; }

 private:
  std::mt19937_64 bits_;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace regista
