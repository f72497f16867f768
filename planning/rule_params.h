// The numbers of the rules of the game, with the margins by which they are kept.
#pragma once

#include "world_model/params.h"

namespace regista {

/// Distances as in the SSL rules, "Stop", "Ball placement", "Free kick"; the margin on top takes up noise and corners.
struct RuleParams {
  double ball_radius_m = 0.0215;
  double ball_distance_m = 0.5;  ///< between body and ball, or the line to where it is placed
  double area_distance_m = 0.2;  ///< between body and the opponent's defence area, in stop and at free kicks
  double stop_speed_mps = 1.4;   ///< the rule says 1.5; a robot drives up to 5 % faster than it is told
  double margin_m = 0.05;        ///< corners are rounded by up to 0.02 m, cameras are off by as much
  bool operator==(const RuleParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("ball_radius_m", self.ball_radius_m, Range{0.001, 0.5}, "m", "radius of the ball");
    v("ball_distance_m", self.ball_distance_m, Range{0.0, 5.0}, "m", "to the ball while the rules keep robots off it");
    v("area_distance_m", self.area_distance_m, Range{0.0, 5.0}, "m",
      "to the opponent's defence area in stop and at free kicks");
    v("stop_speed_mps", self.stop_speed_mps, Range{0.0, 20.0}, "m/s", "largest speed in stop");
    v("margin_m", self.margin_m, Range{0.0, 1.0}, "m", "kept on top of these distances");
  }
};

}  // namespace regista
