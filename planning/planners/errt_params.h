// What can be set of the extended RRT: the constants of Pinheiro, Maximo & Yoneyama (LARS 2020), section IV A.
#pragma once

#include "world_model/params.h"

namespace regista {

struct ErrtParams {
  /// The paper prints 15 mm, and 18 mm as the size of a robot, which is 180 mm: a slip of ten, and 2,500 steps of 15 mm
  /// do not search a field.
  double step_m = 0.15;
  double goal_bias = 0.7;
  double waypoint_bias = 0.2;
  bool operator==(const ErrtParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("step_m", self.step_m, Range{0.001, 10.0}, "m", "longest step; the paper prints 0.015");
    v("goal_bias", self.goal_bias, Range{0.0, 1.0}, "", "share of the samples that are the goal");
    v("waypoint_bias", self.waypoint_bias, Range{0.0, 1.0}, "", "share that are points of the previous path");
  }
};

}  // namespace regista
