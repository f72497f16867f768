// What a controller is handed, checked before anything of it is remembered. All throw std::invalid_argument with what
// is wrong and with which robot.
#pragma once

#include <cstdint>
#include <map>
#include <span>

#include "planning/plan.h"
#include "world_model/types/world_state.h"

namespace regista {

/// One team's plans by robot number.
using PlansByRobot = std::map<std::uint16_t, const RobotPlan*>;

/// Throws unless all numbers of all robots are finite.
void require_finite(const WorldState& world);

/// The team's plans; throws unless all numbers of all plans are finite and no robot of the team has two. Points into
/// `plans`.
PlansByRobot plans_of(Team team, std::span<const RobotPlan> plans);

/// The time to count with, s: longer pauses must not make commands jump. Throws unless dt_s is positive and finite.
double period(double dt_s, double period_max_s);

}  // namespace regista
