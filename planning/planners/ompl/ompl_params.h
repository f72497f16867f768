// What can be set of the planners taken from OMPL. Defaults are those of Pinheiro, Maximo & Yoneyama (LARS 2020) where
// they state one, else OMPL's.
#pragma once

#include "world_model/params.h"

namespace regista {

struct OmplParams {
  double range_m = 0.0;                  ///< longest motion of the RRT kind; 0: OMPL's, a fifth of the field's diagonal
  double goal_bias = 0.7;                ///< of RRT* and Informed RRT*; OMPL's own is 0.05
  std::int64_t samples_per_batch = 100;  ///< of BIT*, and all samples FMT* begins with
  bool simplify = false;                 ///< OMPL's PathSimplifier afterwards
  double stop_length_m = 0.0;            ///< a path shorter than this ends the search; 0: the budget does
  bool operator==(const OmplParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("range_m", self.range_m, Range{0.0, 100.0}, "m",
      "longest motion of rrt_star, informed_rrt_star, rrt_connect; 0: "
      "OMPL's choice");
    v("goal_bias", self.goal_bias, Range{0.0, 1.0}, "", "share of samples at the goal (rrt_star, informed_rrt_star)");
    v("samples_per_batch", self.samples_per_batch, Range{1.0, 1e6}, "", "of bit_star and fmt_star");
    v("simplify", self.simplify, Range{0.0, 1.0}, "",
      "shorten and smooth the path; at least one pass, whatever the "
      "budget");
    v("stop_length_m", self.stop_length_m, Range{0.0, 1e9}, "m",
      "a shorter path ends the search (rrt_star, informed_rrt_star, bit_star); 0: the budget does");
  }
};

}  // namespace regista
