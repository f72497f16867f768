// What a team's frame remembers: the paths of the frame before, and nothing else.
#include <catch2/catch.hpp>
#include <optional>

#include "planning/team_planner.h"
#include "planning/uniform.h"
#include "tests/planning/random_team.h"

namespace regista {

using testing::random_targets;
using testing::random_world;

TEST_CASE("a frame's plans are the same in a new planner and whatever came before") {
  for (const PlannerEntry& entry : planners()) {
    if (!entry.guarantees.deterministic) continue;
    std::mt19937_64 random(18);
    TeamPlanner old(Team::yellow, {});
    old.use(entry.name);
    for (std::uint64_t frame = 0; frame < 30; ++frame) {
      const WorldState world = random_world(random, frame);
      const Targets targets = random_targets(random);
      TeamPlanner fresh(Team::yellow, {});
      fresh.use(entry.name);
      CAPTURE(entry.name, frame);
      REQUIRE(old.plan(division_a(), world, targets).plans == fresh.plan(division_a(), world, targets).plans);
      REQUIRE(old.picture() == fresh.picture());
    }
  }
}

TEST_CASE("a random planner's path stays while nothing moves, and after a swap") {
  std::mt19937_64 random(20);
  WorldState world = random_world(random, 1);
  const Targets targets = random_targets(random);
  TeamPlanner planner(Team::yellow, {});
  const TeamPlans first = planner.plan(division_a(), world, targets);
  planner.use("rrt");
  TeamPlans before = first;
  int bent = 0;
  for (int frame = 0; frame < 5; ++frame) {
    ++world.sequence;
    const TeamPlans plans = planner.plan(division_a(), world, targets);
    for (std::size_t i = 0; i < plans.plans.size(); ++i) {
      if (before.plans[i].plan.status != PlanStatus::ok) continue;
      REQUIRE(plans.plans[i].plan.path == before.plans[i].plan.path);
      bent += plans.plans[i].plan.path.size() > 2;
    }
    before = plans;
  }
  REQUIRE(bent >= 3 * 5);
}

TEST_CASE("a planner that begins in the middle plans like the others from the next targets on") {
  // The one frame's memory is all there is: it ends with the errand, so a replay may begin anywhere.
  std::mt19937_64 random(25);
  PlanningParams params;
  params.side_change_gain = 0.05;
  TeamPlanner old(Team::yellow, params);
  std::optional<TeamPlanner> late;
  int differing = 0;
  for (std::uint64_t errand = 0; errand < 20; ++errand) {
    WorldState world = random_world(random, errand * 100);
    const Targets targets = random_targets(random);
    for (int frame = 0; frame < 40; ++frame) {
      ++world.sequence;
      for (RobotState& robot : world.robots) {
        robot.pose.position_m += Vec2(uniform(random, -0.05, 0.05), uniform(random, -0.05, 0.05));
      }
      const bool is_new_errand = errand % 2 == 1;
      if (!is_new_errand && frame == 20) late.emplace(Team::yellow, params);
      const std::vector<RobotPlan> recorded = old.plan(division_a(), world, targets).plans;
      if (!late) continue;
      const std::vector<RobotPlan> replayed = late->plan(division_a(), world, targets).plans;
      if (is_new_errand) REQUIRE(replayed == recorded);
      for (std::size_t i = 0; i < recorded.size(); ++i) {
        differing += replayed[i] != recorded[i];
        REQUIRE(replayed[i].plan.status == recorded[i].plan.status);
      }
    }
  }
  CHECK(differing > 0);  // else nothing was kept and this shows nothing
}

}  // namespace regista
