// What a controller is handed, checked before anything of it is remembered: the numbers that it reads. All throw
// std::invalid_argument with the value, and the robot where it is one's.
#pragma once

#include <cstdint>
#include <map>
#include <span>

#include "planning/plan.h"
#include "world_model/types/world_state.h"

namespace regista {

/// One team's plans by robot number.
using PlansByRobot = std::map<std::uint16_t, const RobotPlan*>;

/// Throws unless pose and twist of every robot are finite.
void require_finite(const WorldState& world);

/// The team's plans; throws unless path, target heading and speed limit of every plan are finite, or when a robot of
/// the team has two. Points into `plans`.
PlansByRobot plans_of(Team team, std::span<const RobotPlan> plans);

/// The time to count with, s: longer pauses must not make commands jump. Throws unless dt_s is positive and finite.
double checked_period_s(double dt_s, double period_max_s);

}  // namespace regista
