// How long a team's frame may take: the stopwatch, time limits, and planners that never stop by themselves.
#include <catch2/catch.hpp>

#include "planning/team_planner.h"
#include "tests/planning/random_team.h"

namespace regista {

using testing::kRobots;
using testing::random_targets;
using testing::random_world;

TEST_CASE("the stopwatch is read around every plan and ends searches that take too long") {
  std::mt19937_64 random(22);
  const WorldState world = random_world(random, 1);
  const Targets targets = random_targets(random);
  std::int64_t now_ns = 0;
  const TeamPlanner::Stopwatch stopwatch = [&now_ns] { return now_ns += 100; };
  PlanningParams params;
  TeamPlanner planner(Team::yellow, params);
  const TeamPlans timed = planner.plan(division_a(), world, targets, &stopwatch);
  REQUIRE(timed.durations_ns.size() == timed.plans.size());
  for (const std::int64_t duration_ns : timed.durations_ns) CHECK(duration_ns == 100);
  CHECK(timed.frame_ns == std::int64_t{100} * (2 * kRobots + 1));
}

TEST_CASE("a search that takes longer than budget_us ends with not_found") {
  // Two walls of opponents across the field with gaps at opposite ends: a tree needs many samples.
  WorldState world;
  world.robots.resize(1);
  world.robots[0].id = {Team::yellow, 0};
  world.robots[0].pose.position_m = {-1.5, -4.0};
  std::uint16_t number = 0;
  for (const double x : {0.0, 2.0}) {
    for (double along = -4.7; along < 3.6; along += 0.2) {
      RobotState robot;
      robot.id = {Team::blue, number++};
      robot.pose.position_m = {x, x > 0.0 ? -along : along};
      world.robots.push_back(robot);
    }
  }
  Targets targets;
  targets.targets.resize(1);
  targets.targets[0].pose.position_m = {3.5, 3.0};
  std::int64_t now_ns = 0;
  const TeamPlanner::Stopwatch stopwatch = [&now_ns] { return now_ns += 100; };
  PlanningParams params;
  params.iterations = 100000;
  for (std::int64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    params.seed = seed;
    params.budget_us = 0;
    params.frame_period_s = 0.0;
    TeamPlanner patient(Team::yellow, params);
    patient.use("rrt");
    REQUIRE(patient.plan(division_a(), world, targets, &stopwatch).plans[0].plan.status == PlanStatus::ok);
    // Each look at the watch costs 100 ns, so 1 µs is ten looks.
    params.budget_us = 1;
    TeamPlanner hurried(Team::yellow, params);
    hurried.use("rrt");
    const TeamPlans plans = hurried.plan(division_a(), world, targets, &stopwatch);
    REQUIRE(plans.plans[0].plan.status == PlanStatus::not_found);
    REQUIRE(plans.durations_ns[0] <= 1500);
    // The same as the share of the frame: of one robot all of it.
    params.budget_us = 0;
    params.frame_period_s = 1e-6;
    TeamPlanner sharing(Team::yellow, params);
    sharing.use("rrt");
    REQUIRE(sharing.plan(division_a(), world, targets, &stopwatch).plans[0].plan.status == PlanStatus::not_found);
    REQUIRE(sharing.plan(division_a(), world, targets).plans[0].plan.status == PlanStatus::ok);
    sharing.use("visibility_sampling");
    REQUIRE(sharing.plan(division_a(), world, targets, &stopwatch).plans[0].plan.status == PlanStatus::ok);
  }
}

TEST_CASE("without a time limit anytime planners end after anytime_iterations") {
  std::mt19937_64 random(24);
  const WorldState world = random_world(random, 1);
  const Targets targets = random_targets(random);
  const auto plans = [&](std::int64_t iterations, std::int64_t anytime_iterations) {
    PlanningParams params;
    params.iterations = iterations;
    params.anytime_iterations = anytime_iterations;
    TeamPlanner planner(Team::yellow, params);
    planner.use("rrt_star");
    return planner.plan(division_a(), world, targets).plans;
  };
  CHECK(plans(50, 100) == plans(5000, 100));
  CHECK(plans(100, 50) != plans(100, 150));
}

}  // namespace regista
