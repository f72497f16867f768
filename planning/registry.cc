#include "planning/registry.h"

#include <array>
#include <type_traits>
#include <vector>

#include "planning/planners/apf.h"
#include "planning/planners/astar_grid.h"
#include "planning/planners/dvg.h"
#include "planning/planners/errt.h"
#include "planning/planners/irrt.h"
#include "planning/planners/ompl/ompl_planner.h"
#include "planning/planners/rrt.h"
#include "planning/planners/rrt_plan.h"
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

constexpr std::string_view kDvgPaper = "Costa & Tonidandel, DVG+A* and RRT path-planners";
constexpr std::string_view kIterativeRrtPaper = "Iterative RRT-Smooth for soccer robots, table I";
constexpr std::string_view kSamplingPaper = "Pinheiro, Maximo & Yoneyama, Comparison of Sampling-based Path Planners";
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
    PlannerEntry{"dvg",
                 "dynamic visibility graph: A* over octagons near the straight line",
                 kDvgPaper,
                 {false, false, true, false},
                 make<Dvg>},
    PlannerEntry{"dvg_grouped",
                 "the same, obstacles near each other made one",
                 kDvgPaper,
                 {false, false, true, false},
                 make<DvgGrouped>},
    PlannerEntry{
        "rrt", "rapidly exploring random tree, path pruned", kDvgPaper, {false, false, false, false}, make<Rrt>},
    PlannerEntry{"rrt_plan",
                 "random tree with goal bias, path as the tree has it",
                 kIterativeRrtPaper,
                 {false, false, false, false},
                 make<RrtPlan>},
    PlannerEntry{
        "rrt_smooth", "the same, path pruned", kIterativeRrtPaper, {false, false, false, false}, make<RrtSmooth>},
    PlannerEntry{"irrt",
                 "random trees from start and goal within a widening rectangle",
                 kIterativeRrtPaper,
                 {false, false, false, false},
                 make<Irrt>},
    PlannerEntry{
        "irrt_smooth", "the same, path pruned", kIterativeRrtPaper, {false, false, false, false}, make<IrrtSmooth>},
    PlannerEntry{"errt",
                 "random tree drawn to the goal and to the path found before",
                 kSamplingPaper,
                 {false, false, false, false},
                 make<Errt>},
    PlannerEntry{"astar_grid",
                 "A* on a grid of 50 mm cells, eight neighbours",
                 kIterativeRrtPaper,
                 {false, false, true, false},
                 make<AstarGrid>},
    PlannerEntry{"apf",
                 "artificial potential field, local minima left along the wall",
                 kIterativeRrtPaper,
                 {false, false, true, false},
                 make<Apf>},
    PlannerEntry{"rrt_star",
                 "RRT* of OMPL with the exact motion check",
                 kSamplingPaper,
                 {false, false, false, true},
                 make<RrtStar>},
    PlannerEntry{"fmt_star",
                 "FMT* of OMPL with the exact motion check",
                 kSamplingPaper,
                 {false, false, false, false},
                 make<FmtStar>},
    PlannerEntry{"bit_star",
                 "BIT* of OMPL with the exact motion check",
                 kSamplingPaper,
                 {false, false, false, true},
                 make<BitStar>},
    PlannerEntry{"rrt_connect",
                 "RRT-Connect of OMPL with the exact motion check",
                 "Kuffner & LaValle, RRT-Connect (2000)",
                 {false, false, false, false},
                 make<RrtConnect>},
    PlannerEntry{"informed_rrt_star",
                 "Informed RRT* of OMPL with the exact motion check",
                 "Gammell, Srinivasa & Barfoot, Informed RRT* (2014)",
                 {false, false, false, true},
                 make<InformedRrtStar>},
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
