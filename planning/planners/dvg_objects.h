// What DVG may do to its objects before it looks at them: near ones become one (figure 4), far ones grow (figure 25).
#pragma once

#include <vector>

#include "planning/planners/dvg_params.h"
#include "world_model/types/geometry.h"

namespace regista::dvg {

/// A robot or ball. r of the published geometry: 240 mm for robots, 300 mm for the ball.
struct Object {
  Vec2 centre = Vec2::Zero();
  double radius_m = 0.0;
  bool is_enlarged = false;  ///< group or grown: larger than what it stands for
  bool operator==(const Object&) const = default;
};

/// Objects whose centres are nearer than d_group, also by way of others, become one: its centre is the mean of theirs,
/// its radius the distance to the farthest member's centre plus that member's radius; where another member would reach
/// out of it, which the paper's words leave open, that one's is taken. A group that would hold start or goal is not
/// formed. Groups come where their first member was.
void group_near(std::vector<Object>& objects, const Vec2& start, const Vec2& goal, double group_distance_m);

/// Radius r + growth · (distance to goal − unchanged_within), at most r_max, and never so large that it covers start or
/// goal.
void grow_far(std::vector<Object>& objects, const Vec2& start, const Vec2& goal, const DvgParams& params);

}  // namespace regista::dvg
