// The force of an artificial potential field at a point: Khatib, "Real-time obstacle avoidance for manipulators and
// mobile robots" (1986).
#pragma once

#include "planning/obstacle_field.h"
#include "planning/planners/apf_params.h"

namespace regista {

/// A unit force towards the goal (a conic well), and from each obstacle nearer than ρ0 a force
/// η (1/ρ − 1/ρ0) / ρ² away from it; η so that it is 1 at the distance of balance. Near the goal the latter weakens
/// with the square of the distance, else an obstacle beside it would keep the robot away (Ge & Cui 2000).
Vec2 potential_force(const ObstacleField& field, std::span<const std::size_t> ignored, const Vec2& goal,
                     const Vec2& point, const ApfParams& params);

}  // namespace regista
