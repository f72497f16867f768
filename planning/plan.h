// What planning answers for one query, and for one robot of a team.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "planning/targets.h"

namespace regista {

/// ok: the path leads to the goal. not_found: the budget or the samples were spent without one. unreachable: proof that
/// there is none. invalid: the query made no sense, `reason` says why.
enum class PlanStatus : std::uint8_t { ok, not_found, unreachable, invalid };

const char* name(PlanStatus status);

struct Plan {
  PlanStatus status = PlanStatus::invalid;
  bool start_moved = false;  ///< the start lay in obstacles; the first leg leaves them
  bool goal_moved = false;   ///< the goal was covered; the path leads to the nearest free point
  std::vector<Vec2> path;    ///< start … end, metres, at least two points when ok; start alone when start = goal.
                             ///< not_found, unreachable: leads as near to the goal as is known, or out of a
                             ///< team-mate's way (`reason` says so), may be empty
  double length_m = 0.0;     ///< of path
  std::string reason;        ///< empty when ok
  bool operator==(const Plan&) const = default;
};

/// One robot's plan as the controller gets it.
struct RobotPlan {
  RobotId robot;
  Time captured{};                     ///< capture time of the world it is made from
  std::uint64_t world_sequence = 0;    ///< WorldState::sequence it is made from
  std::uint64_t targets_sequence = 0;  ///< Targets::sequence it is made from
  std::uint32_t set_size = 1;          ///< how many plans the team has for this world state
  std::string planner;                 ///< registry name
  std::uint64_t generation = 0;        ///< counts up with every change of planner
  Target target;                       ///< what the plan is for
  Plan plan;
  bool operator==(const RobotPlan&) const = default;
};

}  // namespace regista
