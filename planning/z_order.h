// Places in the order of a Z-curve (Morton): neighbours in the list are mostly neighbours in the plane.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "world_model/types/geometry.h"

namespace regista {

/// Only scratch memory is kept between two lists.
class ZOrder {
 public:
  /// For coordinates up to extent_m (>= 0) in magnitude.
  void clear(double extent_m);

  void add(const Vec2& place);

  struct Entry {
    std::uint32_t key;    ///< place on the curve
    std::uint32_t index;  ///< how many were added before
  };

  /// Those on one place in the order in which they were added. Valid until the next call.
  std::span<const Entry> sort();

 private:
  double extent_m_ = 0.0;
  double scale_ = 0.0;  ///< cells per metre
  std::vector<Entry> entries_;
  std::vector<Entry> scratch_;
};

}  // namespace regista
