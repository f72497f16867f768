// How far a bench is, on stderr: a bar on a terminal, else a line now and then.
#pragma once

#include <cstddef>
#include <string>

#include "modules/bench/stopwatch.h"

namespace regista::bench {

class Progress {
 public:
  /// `total` steps of `what`.
  Progress(std::string what, std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance(std::size_t steps = 1);

 private:
  void show() const;

  std::string what_;
  std::size_t total_;
  std::size_t done_ = 0;
  bool terminal_;
  double shown_at_s_ = 0.0;
  SingleShot since_;
};

}  // namespace regista::bench
