// What can be set of DVG+A*: the constants of Costa & Tonidandel, section 3, and what they switch on and off.
#pragma once

#include "world_model/params.h"

namespace regista {

struct DvgParams {
  double region_half_width_m = 1.0;  ///< d_AR
  bool edge_limit = true;            ///< only edges at least as long as their objects' centres are apart
  bool grouping = false;             ///< objects near each other become one
  double group_distance_m = 0.5;     ///< d_group; table 3 also has 1.5
  bool variable_radius = false;      ///< objects grow with their distance from the goal (figure 25)
  /// Figure 25 is lost and its text gives no numbers. Objects nearer to the goal than this (d4) keep their radius.
  double unchanged_within_m = 1.0;
  double growth = 0.05;        ///< metres of radius per metre farther away; rebuilt, see above
  double radius_max_m = 0.48;  ///< r_max; rebuilt as twice r_ally
  /// In the published geometry only: how near an edge to the goal may come to the centre of an object that covers it.
  double robot_radius_m = 0.09;
  /// The paper gives that exception because objects may cover the goal, but its words are for every object. Taken at
  /// its word, last legs cut through all safety distances, and robots of 90 mm each would touch.
  bool exception_everywhere = false;
  bool operator==(const DvgParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("region_half_width_m", self.region_half_width_m, Range{0.01, 100.0}, "m", "d_AR of the active region");
    v("edge_limit", self.edge_limit, Range{}, "", "only edges as long as their objects' centres are apart");
    v("grouping", self.grouping, Range{}, "", "objects near each other become one");
    v("group_distance_m", self.group_distance_m, Range{0.0, 10.0}, "m", "d_group: nearer centres are one group");
    v("variable_radius", self.variable_radius, Range{}, "", "objects grow with their distance from the goal");
    v("unchanged_within_m", self.unchanged_within_m, Range{0.0, 100.0}, "m", "no growth this near to the goal");
    v("growth", self.growth, Range{0.0, 1.0}, "", "radius gained per distance from the goal");
    v("radius_max_m", self.radius_max_m, Range{0.0, 10.0}, "m", "no object grows beyond this radius");
    v("robot_radius_m", self.robot_radius_m, Range{0.0, 1.0}, "m",
      "how near an edge to a covered goal may come to a centre (published geometry only)");
    v("exception_everywhere", self.exception_everywhere, Range{}, "",
      "that holds for objects that do not cover the goal, too (published geometry only)");
  }
};

/// The defaults of `dvg_grouped`.
inline DvgParams grouped_dvg_params() {
  DvgParams params;
  params.grouping = true;
  return params;
}

}  // namespace regista
