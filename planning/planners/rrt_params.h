// What can be set of the rapidly exploring random trees: constants of the papers, as printed where they can be used.
#pragma once

#include "world_model/params.h"

namespace regista {

/// `rrt`, Costa & Tonidandel.
struct RrtParams {
  double step_m = 0.36;        ///< λ
  double goal_reach_m = 0.36;  ///< d_goal: a node this near is joined to the goal
  std::int64_t leaf_size = 5;  ///< of the KD-tree (figures 8 and 9)
  bool operator==(const RrtParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("step_m", self.step_m, Range{0.001, 10.0}, "m", "length of every step");
    v("goal_reach_m", self.goal_reach_m, Range{0.0, 10.0}, "m", "a node this near to the goal is joined to it");
    v("leaf_size", self.leaf_size, Range{1.0, 10000.0}, "", "points in a leaf of the KD-tree");
  }
};

/// `rrt_plan`, `rrt_smooth`, `irrt`, `irrt_smooth`: "Path finding based on iterative RRT-Smooth".
///
/// The paper's ε is 50 and its lengths are 708–850, without unit. One unit serves both, so its paths are 14–17 steps
/// long. In millimetres they would be 0.7 m, less than four robots side by side, for a figure that crosses a field of
/// robots; in centimetres they are 7–8.5 m, which fits a field of 9 × 6 m. So ε is read as 50 cm. 0.05 is the other
/// reading; it needs about ten times the samples.
struct IterativeRrtParams {
  double goal_bias = 0.3;      ///< pGoal
  double epsilon_m = 0.5;      ///< longest step, and how near to the goal a node is joined to it
  double first_width_m = 1.0;  ///< of the search rectangle; "determined according to the size of search area"
  bool operator==(const IterativeRrtParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("goal_bias", self.goal_bias, Range{0.0, 1.0}, "", "share of the samples that are the goal");
    v("epsilon_m", self.epsilon_m, Range{0.001, 10.0}, "m", "longest step, and reach of the goal");
    v("first_width_m", self.first_width_m, Range{0.01, 100.0}, "m", "width of the first search rectangle (irrt)");
  }
};

}  // namespace regista
