#include "planning/registry.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "planning/planners/rrt.h"
#include "planning/planners/visibility_sampling.h"
#include "planning/planners/visibility_sampling_single.h"

namespace regista {
namespace {

template <class P>
std::unique_ptr<Planner> make() {
  return std::make_unique<P>();
}

constexpr std::string_view kVisibilityPaper = "A Mapping & Planning Algorithm for RoboCup Small Size League (2022)";

// Name, what, source, {complete, optimal, deterministic, anytime}, factory.
constexpr std::array kPlanners{
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

/// Levenshtein distance: insertions, deletions and replacements that turn one word into the other.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

[[noreturn]] void refuse(std::string_view name) {
  const auto nearest = std::min_element(kPlanners.begin(), kPlanners.end(), [name](const auto& a, const auto& b) {
    return distance(name, a.name) < distance(name, b.name);
  });
  std::string message =
      "unknown planner '" + std::string(name) + "', did you mean '" + std::string(nearest->name) + "'? Known:";
  for (const PlannerEntry& entry : kPlanners) {
    message += (&entry == kPlanners.data() ? " " : ", ") + std::string(entry.name);
  }
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

std::unique_ptr<Planner> make_planner(std::string_view name) { return planner_entry(name).make(); }

}  // namespace regista
