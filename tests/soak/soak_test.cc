// Never a path through an obstacle: very many random queries to every planner of the registry, each answer checked by
// the independent clearance function. A hundredth of them by default; ./dev soak names a planner in REGISTA_SOAK, which
// then gets all of them.
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>
#include <iostream>

#include "planning/registry.h"
#include "planning/uniform.h"
#include "tests/support/planning_oracles.h"
#include "tests/support/planning_worlds.h"
#include "tests/support/share.h"
#include "tests/support/varied_worlds.h"

namespace regista::testing {
namespace {

constexpr int kQueries = 1'000'000;
constexpr int kQueriesOfRandomPlanners = 100'000;
constexpr int kShareInTests = 100;
constexpr int kQueriesPerWorld = 20;
constexpr int kQueriesPerReport = 50'000;
constexpr int kWorldsPerCrowd = 250;
constexpr std::int64_t kIterations = 200;  // few, so that random planners are asked often rather than long

/// The planner to soak; nullptr in a usual test.
const char* soaked_planner() { return std::getenv("REGISTA_SOAK"); }

/// A crowd now and then, for they take long; else small and varied, or like a match.
ObstacleField soak_field(std::uint64_t world, std::mt19937_64& random) {
  if (world % kWorldsPerCrowd == 0) return random_field(random, 100 + random() % 301);
  return uniform(random) < 0.7 ? varied_field(random, random() % 20) : random_field(random, random() % 40);
}

/// Like random_request, but some ends lie out of bounds, on a boundary, or on each other.
PlanRequest soak_request(std::mt19937_64& random, const ObstacleField& field) {
  PlanRequest request = random_request(random, field);
  request.budget.iterations = kIterations;
  for (Vec2* end : {&request.start, &request.goal}) {
    const double kind = uniform(random);
    if (kind < 0.05) *end *= 2.0;
    if (kind < 0.9 || field.size() == 0) continue;
    const Obstacle& obstacle = field.obstacles()[random() % field.size()];
    const double angle_rad = uniform(random, -std::numbers::pi, std::numbers::pi);
    *end = obstacle.b + rotated({obstacle.radius_m, 0.0}, angle_rad);
  }
  if (uniform(random) < 0.01) request.goal = request.start;
  return request;
}

/// What is wrong with the answer. One that did not get to its goal is held to the same laws as far as it goes.
std::string fault(const ObstacleField& field, PlanRequest request, Plan plan) {
  if (plan.status == PlanStatus::ok) return fault_of(field, request, plan);
  if (plan.status == PlanStatus::invalid) return "is invalid: " + plan.reason;
  if (plan.reason.empty()) return "has no reason to fail";
  if (plan.path.empty()) return "";
  request.goal = plan.path.back();
  plan.goal_moved = false;
  plan.reason.clear();
  return fault_of(field, request, plan);
}

/// One planner and its queries, world by world; the team of a world shares a graph, and knows what it answered last.
class Soak {
 public:
  explicit Soak(const PlannerEntry& entry) : entry_(entry), planner_(entry.make({})) {}

  /// What was wrong first, and the query to paste on the error output, which Catch would wrap; empty when nothing was.
  std::string run(int queries) {
    for (int world = 0; world < queries / kQueriesPerWorld; ++world) {
      const std::string wrong = run_world(static_cast<std::uint64_t>(world));
      if (!wrong.empty()) return wrong;
      if (soaked_planner() != nullptr && answered_ % kQueriesPerReport == 0) report();
    }
    return "";
  }

  int answered() const { return answered_; }
  int ok() const { return ok_; }

 private:
  std::string run_world(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    graph_.reset(soak_field(seed, random));
    const ObstacleField& field = graph_.field();
    plan_.path.clear();
    for (int i = 0; i < kQueriesPerWorld; ++i) {
      PlanRequest request = soak_request(random, field);
      request.previous_path = plan_.path;
      planner_->plan(graph_, request, plan_);
      ++answered_;
      if (plan_.status == PlanStatus::ok) ++ok_;
      const std::string wrong = fault(field, request, plan_);
      if (wrong.empty()) continue;
      std::cerr << pasteable(field, request) << std::endl;
      return std::string(entry_.name) + ", world " + std::to_string(seed) + ", query " + std::to_string(i) +
             ": the path " + wrong;
    }
    return "";
  }

  void report() const {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin_;
    std::cout << entry_.name << ": " << answered_ << " answers, " << ok_ << " ok, " << spent.count() << " s"
              << std::endl;
  }

  const PlannerEntry& entry_;
  std::unique_ptr<Planner> planner_;
  graph::SharedGraph graph_;
  Plan plan_;
  int answered_ = 0, ok_ = 0;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

TEST_CASE("the soak catches a path through an obstacle, whatever it is called") {
  const ObstacleField field(test_bounds(), {disc({0, 0}, 0.5)});
  PlanRequest request;
  request.start = {-3, 0};
  request.goal = {3, 0};
  for (const double y : {0.0, 0.6}) {
    Plan plan;
    plan.status = PlanStatus::ok;
    plan.path = {request.start, {0, y}, request.goal};
    plan.length_m = length_of(plan.path);
    CHECK(fault(field, request, plan).empty() == (y > 0.5));
    plan.status = PlanStatus::not_found;
    plan.reason = "test";
    plan.path.back() = {2, 0};
    plan.length_m = length_of(plan.path);
    CHECK(fault(field, request, plan).empty() == (y > 0.5));
  }
}

TEST_CASE("no planner leads through an obstacle") {
  if (const char* named = soaked_planner()) {
    if (std::string_view(named) == "safety") return;  // safety_soak_test.cc
    REQUIRE_NOTHROW(planner_entry(named));
  }
  for (const PlannerEntry& entry : planners()) {
    if (soaked_planner() != nullptr && entry.name != soaked_planner()) continue;
    DYNAMIC_SECTION(entry.name) {
      const int all = entry.guarantees.deterministic ? kQueries : kQueriesOfRandomPlanners;
      const int queries = soaked_planner() != nullptr ? all : share_of(all / kShareInTests);
      Soak soak(entry);
      REQUIRE(soak.run(queries) == "");
      CHECK(soak.answered() == queries);
      CHECK(soak.ok() > queries / 10);
    }
  }
}

}  // namespace regista::testing
