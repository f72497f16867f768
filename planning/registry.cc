#include "planning/registry.h"

#include <array>
#include <type_traits>
#include <vector>

#include "planning/planners/rrt.h"
#include "planning/planners/tangent.h"
#include "planning/planners/visibility_sampling.h"
#include "planning/planners/visibility_sampling_single.h"
#include "world_model/params.h"

namespace regista {
namespace {

template <class P>
std::unique_ptr<Planner> make(const PlanningParams& params) {
  if constexpr (std::is_constructible_v<P, const PlanningParams&>) {
    return std::make_unique<P>(params);
  } else {
    return std::make_unique<P>();
  }
}

constexpr std::string_view kVisibilityPaper = "A Mapping & Planning Algorithm for RoboCup Small Size League (2022)";

// Name, what, source, {complete, optimal, deterministic, anytime}, factory.
constexpr std::array kPlanners{
    PlannerEntry{"tangent",
                 "exact shortest path over tangents and arcs, on the graph shared by the team",
                 "this project",
                 {true, true, true, false},
                 make<TangentPlanner>},
    PlannerEntry{"visibility_sampling",
                 "visibility sampling on the graph shared by the team",
                 kVisibilityPaper,
                 {false, false, true, false},
                 make<VisibilitySampling>},
    PlannerEntry{"visibility_sampling_single",
                 "visibility sampling as published: one graph per robot",
                 kVisibilityPaper,
                 {false, false, true, false},
                 make<VisibilitySamplingSingle>},
    PlannerEntry{"rrt",
                 "rapidly exploring random tree, path pruned",
                 "Costa & Tonidandel, DVG+A* and RRT path-planners",
                 {false, false, false, false},
                 make<Rrt>},
};

[[noreturn]] void refuse(std::string_view name) {
  std::vector<std::string> names;
  names.reserve(std::size(kPlanners));
  for (const PlannerEntry& entry : kPlanners) names.emplace_back(entry.name);
  std::string message =
      "unknown planner '" + std::string(name) + "', did you mean '" + nearest_name(name, names) + "'? Known:";
  for (const std::string& known : names) message += (known == names.front() ? " " : ", ") + known;
  throw UnknownPlanner(message);
}

}  // namespace

std::span<const PlannerEntry> planners() { return kPlanners; }

const PlannerEntry& planner_entry(std::string_view name) {
  for (const PlannerEntry& entry : kPlanners) {
    if (entry.name == name) return entry;
  }
  refuse(name);
}

std::unique_ptr<Planner> make_planner(std::string_view name, const PlanningParams& params) {
  return planner_entry(name).make(params);
}

}  // namespace regista
