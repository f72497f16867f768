// The table of planners: by name, with what each one promises. A new planner is its two files and one line in
// registry.cc.
#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "planning/planner.h"
#include "planning/planning_params.h"

namespace regista {

struct Guarantees {
  bool complete = false;       ///< finds a path whenever there is one
  bool optimal = false;        ///< and then the shortest
  bool deterministic = false;  ///< the seed changes nothing
  bool anytime = false;        ///< more budget gives better paths
  bool operator==(const Guarantees&) const = default;
};

struct PlannerEntry {
  std::string_view name;
  std::string_view what;    ///< one line
  std::string_view source;  ///< paper or "this project"
  Guarantees guarantees;
  /// With the parameters that concern it; most have none.
  std::unique_ptr<Planner> (*make)(const PlanningParams& params) = nullptr;
};

/// what() is one line: the unknown name, the nearest known one and the list.
struct UnknownPlanner : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a team plans with until it is told otherwise.
inline constexpr std::string_view kDefaultPlanner = "tangent";

std::span<const PlannerEntry> planners();

/// Throws UnknownPlanner.
const PlannerEntry& planner_entry(std::string_view name);
std::unique_ptr<Planner> make_planner(std::string_view name, const PlanningParams& params = {});

}  // namespace regista
