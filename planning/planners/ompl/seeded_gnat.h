// OMPL's default structure of nearest neighbours, but for the seed of its generator, which picks the first pivot of
// every split: a constant, where OMPL takes the next of the process.
#pragma once

#include <ompl/datastructures/NearestNeighborsGNATNoThreadSafety.h>

namespace regista {

template <class T>
class SeededGnat : public ompl::NearestNeighborsGNATNoThreadSafety<T> {
 public:
  SeededGnat() {
    constexpr std::uint_fast32_t kSeed = 1;
    (this->pivotSelector_.*KCenters::generator()).setLocalSeed(kSeed);
  }

 private:
  /// Lends the name of a protected member of what we own.
  struct KCenters : ompl::GreedyKCenters<T> {
    static ompl::RNG ompl::GreedyKCenters<T>::*generator() { return &KCenters::rng_; }
  };
};

}  // namespace regista
