#include "sim/random_targets.h"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "sim/task.h"

namespace regista {
namespace {

WorldState world_of(const std::vector<RobotPlacement>& placements) {
  WorldState world;
  for (const RobotPlacement& placement : placements)
    world.robots.push_back({.id = placement.id, .pose = placement.pose, .twist = {}});
  return world;
}

RobotState& robot_of(WorldState& world, RobotId id) {
  return const_cast<RobotState&>(*find_robot(world, id));  // the world is ours
}

// Lets robots arrive in a random order and checks every target that is given.
void check_many_targets(const FieldGeometry& field, int robots, Team team, std::uint64_t seed) {
  INFO("seed " << seed << ", " << robots << " robots");
  const RandomTargetsParams params;
  RandomTargets task(team, field, params, seed);
  WorldState world = world_of(formation(field, robots, params.robot_radius_m));
  Random random(seed + 1000);
  Targets before;
  std::int64_t reached = 0;
  for (int tick = 0; tick < 200; ++tick) {
    world.captured += Duration{10'000};
    const Targets after = task.update(world);
    REQUIRE(after.team == team);
    REQUIRE(after.targets.size() == static_cast<std::size_t>(robots));
    REQUIRE((after.sequence != before.sequence) == (after.targets != before.targets));
    REQUIRE(after.sequence - before.sequence <= 1);
    for (std::size_t i = 0; i < after.targets.size(); ++i) {
      const Target& target = after.targets[i];
      REQUIRE(target.robot == i);
      for (std::size_t j = 0; j < i; ++j) {
        REQUIRE((target.pose.position_m - after.targets[j].pose.position_m).norm() >= params.target_gap_m);
      }
      if (!before.targets.empty() && target == before.targets[i]) continue;
      REQUIRE(after.captured == world.captured);
      const Vec2 here = find_robot(world, {team, target.robot})->pose.position_m;
      REQUIRE((target.pose.position_m - here).norm() >= params.distance_min_m);
      REQUIRE(is_target_place(target.pose.position_m, field, params));
      REQUIRE_FALSE(target.may_enter_own_area);
    }
    before = after;
    REQUIRE(task.reached() == reached);
    const auto arriving = static_cast<std::uint16_t>(random.uniform() * robots);
    const Vec2 target = after.targets[arriving].pose.position_m;
    const bool arrives = random.chance(0.7);
    robot_of(world, {team, arriving}).pose.position_m = target + Vec2(arrives ? 0.049 : 0.051, 0.0);
    reached += arrives;
  }
  REQUIRE(reached > 100);
}

TEST_CASE("random targets keep all distances") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    check_many_targets(division_a(), 11, Team::yellow, seed);
    check_many_targets(division_b(), 6, Team::blue, seed);
  }
}

TEST_CASE("a target place is inside the lines and outside both areas with the whole body") {
  const FieldGeometry field = division_a();
  const RandomTargetsParams params;
  for (const double side : {-1.0, 1.0}) {
    CHECK(is_target_place({side * 5.9, 3.0}, field, params));
    CHECK_FALSE(is_target_place({side * 5.92, 3.0}, field, params));
    CHECK(is_target_place({0.0, side * 4.4}, field, params));
    CHECK_FALSE(is_target_place({0.0, side * 4.42}, field, params));
    CHECK(is_target_place({side * 4.0, 0.0}, field, params));
    CHECK_FALSE(is_target_place({side * 4.02, 0.0}, field, params));
    CHECK(is_target_place({side * 5.0, side * 2.0}, field, params));
    CHECK_FALSE(is_target_place({side * 5.0, side * 1.98}, field, params));
  }
}

TEST_CASE("a lost robot keeps its target, the other team's robots are ignored") {
  WorldState world = world_of(formation(division_a(), 3, 0.09));
  RandomTargets task(Team::yellow, division_a(), {}, 5);
  const Targets first = task.update(world);
  CHECK(first.sequence == 1);
  world.robots.erase(world.robots.begin());  // Y0
  for (RobotState& robot : world.robots) {
    if (robot.id.team == Team::blue) robot.pose.position_m = first.targets[robot.id.number].pose.position_m;
  }
  CHECK(task.update(world) == first);
  CHECK(task.reached() == 0);
  robot_of(world, {Team::yellow, 2}).pose.position_m = first.targets[2].pose.position_m;
  const Targets second = task.update(world);
  CHECK(second.sequence == 2);
  CHECK(second.targets[0] == first.targets[0]);
  CHECK(second.targets[2] != first.targets[2]);
  CHECK(task.reached(2) == 1);
  CHECK(task.reached(1) == 0);
  CHECK(task.reached(77) == 0);
}

TEST_CASE("same seed, same targets; teams differ") {
  const WorldState world = world_of(formation(division_a(), 11, 0.09));
  Scenario scenario;
  Task yellow = make_task(scenario, Team::yellow);
  Task again = make_task(scenario, Team::yellow);
  Task blue = make_task(scenario, Team::blue);
  CHECK(update(yellow, world) == update(again, world));
  CHECK(update(yellow, world).targets != update(blue, world).targets);
  scenario.seed = 2;
  Task other = make_task(scenario, Team::yellow);
  CHECK(update(yellow, world) != update(other, world));
}

TEST_CASE("distances the field cannot give are refused") {
  RandomTargetsParams params;
  params.distance_min_m = 5.0;
  CHECK_THROWS_WITH(RandomTargets(Team::yellow, division_b(), params, 1), Catch::Contains("5.0"));
  params.distance_min_m = 0.04;
  CHECK_THROWS_AS(RandomTargets(Team::yellow, division_b(), params, 1), std::invalid_argument);
}

TEST_CASE("who shall stand stays where it was first seen") {
  Scenario scenario;
  scenario.task = "stand";
  WorldState world = world_of(initial_placements(scenario));
  Task task = make_task(scenario, Team::blue);
  const Targets first = update(task, world);
  REQUIRE(first.targets.size() == 11);
  for (const Target& target : first.targets) {
    CHECK(target.pose == find_robot(world, {Team::blue, target.robot})->pose);
    CHECK(target.may_enter_own_area == (target.robot == 0));
  }
  for (RobotState& robot : world.robots) robot.pose.position_m += Vec2(0.3, 0.0);
  CHECK(update(task, world) == first);
  CHECK(reached(task) == 0);
}

}  // namespace
}  // namespace regista
