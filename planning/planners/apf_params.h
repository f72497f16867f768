// What can be set of the artificial potential field.
#pragma once

#include "world_model/params.h"

namespace regista {

/// The iterative RRT paper prints no constants of its potential field; these are chosen for robots of 90 mm.
struct ApfParams {
  double influence_m = 0.3;       ///< obstacles farther than this do not repel (Khatib's ρ0)
  double balance_m = 0.1;         ///< at this distance an obstacle repels as much as the goal attracts
  double step_m = 0.05;           ///< of the descent and of following a wall
  std::int64_t steps_max = 5000;  ///< of both together, then it gives up
  bool operator==(const ApfParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("influence_m", self.influence_m, Range{0.01, 10.0}, "m", "obstacles farther than this do not repel");
    v("balance_m", self.balance_m, Range{0.001, 10.0}, "m", "here an obstacle repels as much as the goal attracts");
    v("step_m", self.step_m, Range{0.005, 1.0}, "m", "step of the descent and along walls");
    v("steps_max", self.steps_max, Range{1.0, 1e7}, "", "steps before it gives up");
  }
};

}  // namespace regista
