// On which side paths pass obstacles: two paths with the same ends agree about an obstacle when the curve they enclose
// does not wind around it. Any planner's paths can be compared.
#pragma once

#include "planning/obstacle_field.h"
#include "planning/plan.h"

namespace regista {

/// From frame to frame a robot, or a target that follows the ball, moves by centimetres; farther apart, the ends of two
/// paths say that robot or target were put elsewhere, or that frames are missing.
inline constexpr double kEndsApart_m = 0.3;

/// The point that paths are said to pass on one side or the other.
inline Vec2 middle_of(const Obstacle& obstacle) { return 0.5 * (obstacle.a + obstacle.b); }

/// Appends the obstacles, ignored ones left out, that the two paths pass on different sides: the curve along `now` and
/// back along `before` winds around their middle. Neither path is empty; their ends may be a little apart.
void append_passed_otherwise(std::span<const Obstacle> obstacles, std::span<const std::size_t> ignored,
                             std::span<const Vec2> before, std::span<const Vec2> now, std::vector<ObstacleIndex>& out);

/// Both ends of the paths are so near each other that sides can be compared; false for an empty path.
bool is_same_errand(std::span<const Vec2> before, std::span<const Vec2> now);

/// A change of side, as it is counted: both plans ok, for the same target, and passing some obstacle of the newer
/// plan's field on different sides. The plans are those of consecutive world states.
bool changes_side(const ObstacleField& field, std::span<const std::size_t> ignored, const RobotPlan& before,
                  const RobotPlan& now);

}  // namespace regista
