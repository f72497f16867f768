// A team's frame under the rules of the game: slow in stop and off the ball, at halt nobody moves.
#include <catch2/catch.hpp>

#include "planning/team_planner.h"
#include "tests/planning/random_team.h"

namespace regista {

using testing::kRobots;
using testing::random_targets;
using testing::random_world;

TEST_CASE("in stop plans are slow and their ways keep off the ball, whatever the planner") {
  std::mt19937_64 random(23);
  const Situation stop{SituationKind::stop, {}, {}};
  int moved = 0;
  for (const PlannerEntry& entry : planners()) {
    INFO(entry.name);
    TeamPlanner planner(Team::yellow, {});
    planner.use(entry.name);
    for (int frame = 0; frame < 3; ++frame) {
      WorldState world = random_world(random, 1);
      world.ball = BallState{};
      world.ball->position_m = testing::random_point(random, {{3.0, 3.0}});
      const Targets targets = random_targets(random);
      for (const RobotPlan& plan : planner.plan(division_a(), world, targets, nullptr, stop).plans) {
        CHECK(plan.target.speed_max_mps < 1.5);
        if (plan.plan.status != PlanStatus::ok) continue;
        moved += plan.plan.start_moved;
        const Obstacle ball = disc(world.ball->position_m, 0.5 + 0.0215 + 0.09);
        // The way out of what covers the start may cross it; nothing after it does.
        for (std::size_t i = plan.plan.start_moved ? 2 : 1; i < plan.plan.path.size(); ++i) {
          REQUIRE(is_free(plan.plan.path[i - 1], plan.plan.path[i], ball));
        }
      }
    }
  }
  CHECK(moved > 10);
}

TEST_CASE("a slower target stays slower; without the rules nothing is slowed") {
  std::mt19937_64 random(24);
  const WorldState world = random_world(random, 1);
  Targets targets = random_targets(random);
  targets.targets[3].speed_max_mps = 0.5;
  TeamPlanner planner(Team::yellow, {});
  const TeamPlans stop = planner.plan(division_a(), world, targets, nullptr, {SituationKind::stop, {}, {}});
  CHECK(stop.plans[3].target.speed_max_mps == 0.5);
  const TeamPlans running = planner.plan(division_a(), world, targets);
  for (std::size_t i = 0; i < running.plans.size(); ++i) CHECK(running.plans[i].target == targets.targets[i]);
}

TEST_CASE("at halt every robot has a plan that nobody can drive") {
  std::mt19937_64 random(25);
  const WorldState world = random_world(random, 1);
  TeamPlanner planner(Team::yellow, {});
  const TeamPlans plans =
      planner.plan(division_a(), world, random_targets(random), nullptr, {SituationKind::halt, {}, {}});
  REQUIRE(plans.plans.size() == kRobots);
  for (const RobotPlan& plan : plans.plans) {
    CHECK(plan.plan.path.empty());
    CHECK(plan.plan.status == PlanStatus::not_found);
    CHECK_THAT(plan.plan.reason, Catch::Contains("halt"));
    CHECK(plan.target.speed_max_mps == 0.0);
    CHECK(plan.set_size == kRobots);
  }
}

}  // namespace regista
