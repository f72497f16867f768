// What can be set of A* on a grid.
#pragma once

#include "world_model/params.h"

namespace regista {

struct AstarGridParams {
  /// "50 mm of resolution for the grid, which is the size of the smallest object (the ball)" (Costa & Tonidandel, 3).
  double cell_m = 0.05;
  bool operator==(const AstarGridParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("cell_m", self.cell_m, Range{0.01, 1.0}, "m", "side of a cell");
  }
};

}  // namespace regista
