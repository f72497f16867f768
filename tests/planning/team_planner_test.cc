// A team's frame: who gets a plan, what is in it, exchanging planners, keeping paths.
#include "planning/team_planner.h"

#include <catch2/catch.hpp>
#include <limits>
#include <optional>

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
