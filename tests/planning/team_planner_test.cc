// A team's frame: who gets a plan, what is in it, exchanging planners, keeping paths.
#include "planning/team_planner.h"

#include <catch2/catch.hpp>
#include <limits>

#include "planning/uniform.h"
#include "tests/support/planning_oracles.h"
#include "tests/support/planning_worlds.h"

namespace regista {
namespace {

constexpr std::uint16_t kRobots = 11;

WorldState random_world(std::mt19937_64& random, std::uint64_t sequence) {
  WorldState world;
  world.sequence = sequence;
  world.captured = from_us(static_cast<std::int64_t>(sequence) * 10000);
  for (std::uint16_t i = 0; i < 2 * kRobots; ++i) {
    RobotState robot;
    robot.id = {i < kRobots ? Team::yellow : Team::blue, static_cast<std::uint16_t>(i % kRobots)};
    robot.pose.position_m = testing::random_point(random, {{5.5, 4.0}});
    world.robots.push_back(robot);
  }
  return world;
}

Targets random_targets(std::mt19937_64& random) {
  Targets targets;
  targets.sequence = 77;
  for (std::uint16_t i = 0; i < kRobots; ++i) {
    Target target;
    target.robot = i;
    target.pose.position_m = testing::random_point(random, {{5.5, 4.0}});
    target.may_enter_own_area = i == 0;
    targets.targets.push_back(target);
  }
  return targets;
}

}  // namespace

TEST_CASE("each robot with a target and in the world gets a plan that says what it is made from") {
  std::mt19937_64 random(17);
  WorldState world = random_world(random, 5);
  Targets targets = random_targets(random);
  world.robots.erase(world.robots.begin() + 4);
  targets.targets.erase(targets.targets.begin() + 7);
  TeamPlanner planner(Team::yellow, {});
  const TeamPlans plans = planner.plan(division_a(), world, targets);
  REQUIRE(plans.plans.size() == 9);
  CHECK(plans.durations_ns.empty());
  for (const RobotPlan& plan : plans.plans) {
    CHECK(plan.robot.team == Team::yellow);
    CHECK(plan.robot.number != 4);
    CHECK(plan.robot.number != 7);
    CHECK(plan.target.robot == plan.robot.number);
    CHECK(plan.captured == world.captured);
    CHECK(plan.world_sequence == 5);
    CHECK(plan.targets_sequence == 77);
    CHECK(plan.set_size == 9);
    CHECK(plan.planner == kDefaultPlanner);
    CHECK(plan.generation == 0);
    CHECK(plan.plan.path.front() == find_robot(world, plan.robot)->pose.position_m);
  }
  const GraphPicture picture = planner.picture();
  CHECK(picture.world_sequence == 5);
  CHECK(picture.captured == world.captured);
  CHECK_FALSE(picture.nodes.empty());
}

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

TEST_CASE("planners are exchanged between frames") {
  std::mt19937_64 random(19);
  const WorldState world = random_world(random, 1);
  const Targets targets = random_targets(random);
  TeamPlanner planner(Team::yellow, {});
  planner.use(kDefaultPlanner);
  CHECK(planner.generation() == 0);
  planner.use("rrt");
  CHECK(planner.generation() == 1);
  CHECK_THROWS_AS(planner.use("rtt"), UnknownPlanner);
  CHECK(planner.planner() == "rrt");
  CHECK(planner.generation() == 1);
  for (const RobotPlan& plan : planner.plan(division_a(), world, targets).plans) {
    CHECK(plan.planner == "rrt");
    CHECK(plan.generation == 1);
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
  for (int frame = 0; frame < 5; ++frame) {
    ++world.sequence;
    const TeamPlans plans = planner.plan(division_a(), world, targets);
    for (std::size_t i = 0; i < plans.plans.size(); ++i) {
      const bool was_ok = before.plans[i].plan.status == PlanStatus::ok;
      if (was_ok) CHECK(plans.plans[i].plan.length_m <= before.plans[i].plan.length_m + 1e-9);
    }
    before = plans;
  }
}

TEST_CASE("a target that makes no sense costs that robot its plan and nobody else's") {
  std::mt19937_64 random(21);
  const WorldState world = random_world(random, 1);
  Targets targets = random_targets(random);
  targets.targets[3].pose.position_m.y() = std::numeric_limits<double>::infinity();
  TeamPlanner planner(Team::yellow, {});
  const TeamPlans plans = planner.plan(division_a(), world, targets);
  REQUIRE(plans.plans.size() == kRobots);
  for (const RobotPlan& plan : plans.plans) {
    CHECK((plan.plan.status == PlanStatus::invalid) == (plan.robot.number == 3));
  }
}

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
  // Each look at the watch costs 100 ns, so 1 µs is ten looks: far fewer than a tree needs in an unlucky frame.
  params.budget_us = 1;
  planner.set_params(params);
  planner.use("rrt");
  const TeamPlans hurried = planner.plan(division_a(), world, targets, &stopwatch);
  CHECK(hurried.frame_ns <= std::int64_t{1500} * kRobots);
}

}  // namespace regista
