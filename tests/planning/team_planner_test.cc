// A team's frame: who gets a plan, what is in it, what is refused, exchanging planners.
#include "planning/team_planner.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/planning/random_team.h"

namespace regista {

using testing::kRobots;
using testing::random_targets;
using testing::random_world;

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

TEST_CASE("a team-mate that stops before it gets there is not planned around where it will not be") {
  // It crosses our way from the side, or would: its goal is this side of it.
  WorldState world;
  world.captured = from_us(10000);
  world.robots.resize(2);
  world.robots[0].id = {Team::yellow, 0};
  world.robots[0].pose.position_m = {-2.0, 0.0};
  world.robots[1].id = {Team::yellow, 1};
  world.robots[1].pose.position_m = {0.0, -2.0};
  world.robots[1].twist.velocity_mps = {0.0, 2.0};
  Targets targets;
  targets.targets.resize(1);
  targets.targets[0].pose.position_m = {2.0, 0.0};
  const FieldGeometry field;
  TeamPlanner planner(Team::yellow, {});
  const auto points_of_path = [&] { return planner.plan(field, world, targets).plans.front().plan.path.size(); };
  CHECK(points_of_path() > 2);
  targets.targets.resize(2);
  targets.targets[1].robot = 1;
  targets.targets[1].pose.position_m = {0.0, -0.8};
  CHECK(points_of_path() == 2);
  targets.targets[1].pose.position_m = {0.0, 3.0};
  CHECK(points_of_path() > 2);
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

TEST_CASE("targets of the other team or two for one robot are refused with the values") {
  std::mt19937_64 random(23);
  const WorldState world = random_world(random, 1);
  Targets targets = random_targets(random);
  TeamPlanner planner(Team::yellow, {});
  targets.team = Team::blue;
  CHECK_THROWS_WITH(planner.plan(division_a(), world, targets), Catch::Contains("blue") && Catch::Contains("yellow"));
  targets.team = Team::yellow;
  targets.targets[5].robot = 4;
  CHECK_THROWS_WITH(planner.plan(division_a(), world, targets), Catch::Contains("Y4"));
  targets.targets[5].robot = 5;
  CHECK_NOTHROW(planner.plan(division_a(), world, targets));
}

}  // namespace regista
