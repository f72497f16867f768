#include "sim/random_targets.h"

#include <algorithm>
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

TEST_CASE("a field without far places is refused, however long it is") {
  FieldGeometry narrow = division_a();
  narrow.length_m = 4.0;  // between the areas of 1.8 m there is hardly a line left, beside them nothing
  narrow.width_m = 3.0;
  RandomTargetsParams params;
  params.distance_min_m = 1.0;
  CHECK_THROWS_WITH(RandomTargets(Team::yellow, narrow, params, 1), Catch::Contains("4.0") && Catch::Contains("3.0"));
  FieldGeometry square = division_a();
  square.length_m = 8.0;
  square.width_m = 3.5;
  params.distance_min_m = 3.0;
  CHECK_THROWS_AS(RandomTargets(Team::yellow, square, params, 1), std::invalid_argument);
  params.distance_min_m = 1.0;
  CHECK_NOTHROW(RandomTargets(Team::yellow, square, params, 1));
  Scenario scenario;
  scenario.field = {"custom", 8.0, 3.5, false};
  scenario.robots_per_team = 2;
  scenario.target_distance_min_m = 3.0;
  CHECK_THROWS_WITH(validate(scenario), Catch::Contains("3.0"));
  scenario.task = "stand";
  CHECK_NOTHROW(validate(scenario));
}

// Seconds until robot 0 gets another target while it comes nearer with that speed; 0: not within a minute.
double patience(double give_up_s, double speed_mps) {
  RandomTargetsParams params;
  params.give_up_s = give_up_s;
  RandomTargets task(Team::yellow, division_a(), params, 3);
  WorldState world = world_of({{{Team::yellow, 0}, {{0.0, 0.0}, 0.0}}});
  const Vec2 target = task.update(world).targets[0].pose.position_m;
  for (int tick = 1; tick <= 6000; ++tick) {
    world.captured += Duration{10'000};
    const double distance_m = std::max(2.0 - speed_mps * tick / 100.0, 0.1);
    world.robots[0].pose.position_m = target + Vec2(0.0, distance_m);
    const bool changed = task.update(world).targets[0].pose.position_m != target;
    CHECK(task.reached() == 0);
    if (changed) return tick / 100.0;
  }
  return 0.0;
}

TEST_CASE("a robot that gets no nearer gives up, and that is no arrival") {
  CHECK(patience(5.0, 0.0) == Approx(5.01));    // the first tick brings it near
  CHECK(patience(5.0, 0.005) == Approx(5.01));  // 2.5 cm in that time
  CHECK(patience(5.0, 0.02) == 0.0);            // 5 cm in half of it
  CHECK(patience(0.0, 0.0) == 0.0);
}

TEST_CASE("a robot for which there is no place is not tried again in every frame") {
  RandomTargetsParams params;
  params.distance_min_m = 6.0;
  params.target_gap_m = 10.5;
  int tried = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    INFO("seed " << seed);
    WorldState world = world_of({{{Team::yellow, 0}, {{0.0, 0.0}, 0.0}}, {{Team::yellow, 1}, {{5.0, 0.0}, 0.0}}});
    RandomTargets task(Team::yellow, division_a(), params, seed);
    const Vec2 other = task.update(world).targets[0].pose.position_m;
    if (other.x() > -5.0 || std::abs(other.y()) > 3.8) continue;  // else there is a place nearer to the centre
    ++tried;
    const Vec2 here = world.robots[1].pose.position_m;
    REQUIRE(task.update(world).targets[1].pose.position_m == here);
    world.robots[1].pose.position_m = other;  // from here there are places
    world.captured += Duration{490'000};
    CHECK(task.update(world).targets[1].pose.position_m == here);
    world.captured += Duration{10'000};
    CHECK(task.update(world).targets[1].pose.position_m != here);
  }
  CHECK(tried > 2);
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
