// Seeded random numbers for the simulator, the tasks and their tests, the same on every machine: planning/uniform.h
// with a normal distribution beside. A user of a seed takes a stream of it, mixed(seed, stream), so that it cannot
// shift the numbers of another.
#pragma once

#include <cstdint>
#include <random>

#include "planning/uniform.h"

namespace regista {

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  /// In [0, 1), 53 random bits.
  double uniform() { return regista::uniform(bits_); }
  /// In [low, high), finite low <= high.
  double uniform(double low, double high) { return regista::uniform(bits_, low, high); }
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
