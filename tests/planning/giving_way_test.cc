// Two of a team in each other's only way: one of them leaves it, and both get where they want.
#include "planning/giving_way.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>
#include <random>

#include "planning/team_planner.h"
#include "planning/uniform.h"
#include "world_model/types/field.h"

namespace regista {
namespace {

constexpr double kBody_m = 0.18;

/// A corridor along x through a wall of opponents from side line to side line, for one and a half robots.
WorldState corridor() {
  WorldState world;
  std::uint16_t number = 0;
  const auto add = [&](double x, double y) {
    RobotState robot;
    robot.id = {Team::blue, number++};
    robot.pose.position_m = {x, y};
    world.robots.push_back(robot);
  };
  for (const double side : {-1.0, 1.0}) {
    for (int i = -3; i <= 3; ++i) add(0.2 * i, side * 1.25 * kBody_m);
    for (int i = 1; i < 25; ++i) add(0.0, side * (1.25 * kBody_m + 0.2 * i));
  }
  return world;
}

void add_yellow(WorldState& world, Targets& targets, std::uint16_t number, const Vec2& from, const Vec2& to) {
  RobotState robot;
  robot.id = {Team::yellow, number};
  robot.pose.position_m = from;
  world.robots.push_back(robot);
  std::ranges::sort(world.robots, {}, &RobotState::id);
  Target target;
  target.robot = number;
  target.pose.position_m = to;
  targets.targets.push_back(target);
}

/// Head-on, already in the corridor.
struct HeadOn {
  WorldState world = corridor();
  Targets targets;

  HeadOn(const Vec2& left, const Vec2& right, std::uint16_t left_number = 0, std::uint16_t right_number = 1) {
    add_yellow(world, targets, left_number, left, {2.5, 0.0});
    add_yellow(world, targets, right_number, right, {-2.5, 0.0});
  }
  RobotState& yellow(std::uint16_t number) {
    return *std::ranges::find(world.robots, RobotId{Team::yellow, number}, &RobotState::id);
  }
};

std::vector<RobotPlan> plans_of(const HeadOn& scene, double within_m = PlanningParams{}.give_way_within_m) {
  PlanningParams params;
  params.give_way_within_m = within_m;
  TeamPlanner planner(Team::yellow, params);
  return planner.plan(division_b(), scene.world, scene.targets).plans;
}

bool gives_way(const RobotPlan& plan) { return plan.plan.reason.find("gives way") != std::string::npos; }

/// Along its path, unless that takes it into the other one.
void step(RobotState& robot, const RobotState& other, const std::vector<Vec2>& path) {
  constexpr double kStep_m = 0.03;
  double rest_m = kStep_m;
  Vec2 at = robot.pose.position_m;
  for (const Vec2& vertex : path) {
    const double leg_m = (vertex - at).norm();
    if (leg_m > rest_m) {
      at += rest_m / leg_m * (vertex - at);
      break;
    }
    rest_m -= leg_m;
    at = vertex;
  }
  if ((at - other.pose.position_m).norm() > kBody_m) robot.pose.position_m = at;
}

}  // namespace

TEST_CASE("head-on in a corridor the one with the shorter way out leaves it") {
  const HeadOn near_left({-0.4, 0.0}, {0.0, 0.0});
  const std::vector<RobotPlan> plans = plans_of(near_left);
  CHECK(gives_way(plans[0]));
  CHECK_FALSE(gives_way(plans[1]));
  CHECK(plans[0].plan.status == PlanStatus::unreachable);
  const Vec2 out = plans[0].plan.path.back();
  CHECK(out.x() < -0.7);
  CHECK(std::abs(out.y()) > kBody_m);
  const std::vector<RobotPlan> mirrored = plans_of(HeadOn({0.0, 0.0}, {0.4, 0.0}));
  CHECK_FALSE(gives_way(mirrored[0]));
  CHECK(gives_way(mirrored[1]));
  for (const RobotPlan& plan : plans_of(near_left, 0.0)) CHECK_FALSE(gives_way(plan));
}

TEST_CASE("head-on in the middle of a corridor one of them gives way, whoever is listed first") {
  for (const bool is_swapped : {false, true}) {
    const HeadOn scene({-0.12, 0.0}, {0.12, 0.0}, is_swapped ? 1 : 0, is_swapped ? 0 : 1);
    const std::vector<RobotPlan> plans = plans_of(scene);
    CHECK(gives_way(plans[0]) != gives_way(plans[1]));
  }
}

TEST_CASE("two head-on in a corridor both arrive") {
  for (const double shift_m : {-0.3, -0.1, 0.0, 0.05, 0.25}) {
    HeadOn scene({-2.5, 0.0}, {2.5 + shift_m, 0.0});
    TeamPlanner planner(Team::yellow, {});
    int frames = 0;
    const auto is_there = [](const RobotState& robot, const Target& target) {
      return (robot.pose.position_m - target.pose.position_m).norm() < 1e-9;
    };
    RobotState& left = scene.yellow(0);
    RobotState& right = scene.yellow(1);
    while (!is_there(left, scene.targets.targets[0]) || !is_there(right, scene.targets.targets[1])) {
      INFO(shift_m << ": " << left.pose.position_m.transpose() << ", " << right.pose.position_m.transpose());
      REQUIRE(++frames < 1000);
      const std::vector<RobotPlan> plans = planner.plan(division_b(), scene.world, scene.targets).plans;
      step(left, right, plans[0].plan.path);
      step(right, left, plans[1].plan.path);
    }
  }
}

TEST_CASE("who stands outside of the other's way goes on as far as it stays outside") {
  for (Vec2 place : {Vec2(-1.0, 0.5), Vec2(-2.0, 1.5), Vec2(-0.9, -0.4)}) {
    double way_m = 0.0;
    double last_m = 1.0;
    for (int frame = 0; frame < 20 && last_m > 0.0; ++frame) {
      const RobotPlan plan = plans_of(HeadOn(place, {0.0, 0.0}))[0];
      REQUIRE(gives_way(plan));
      CHECK(plan.plan.length_m == length_of(plan.plan.path));
      last_m = plan.plan.length_m;
      way_m += last_m;
      place = plan.plan.path.back();
      CHECK(std::abs(place.y()) > kBody_m);
    }
    CHECK(last_m < 0.01);
    CHECK(way_m > 0.1);
    CHECK(std::abs(place.y()) < 0.5);
  }
}

TEST_CASE("of two that close each other's way exactly one gives way, wherever they stand in it") {
  std::mt19937_64 random(83);
  int mutual = 0;
  for (int i = 0; i < 400; ++i) {
    const double left_m = uniform(random, -0.7, 0.4);
    const double right_m = uniform(random, left_m + kBody_m, 0.7);
    const HeadOn scene({left_m, uniform(random, -0.04, 0.04)}, {right_m, uniform(random, -0.04, 0.04)});
    const std::vector<RobotPlan> alone = plans_of(scene, 0.0);
    if (std::ranges::any_of(alone, [](const RobotPlan& one) {
          return one.plan.status != PlanStatus::unreachable || one.plan.start_moved;
        }))
      continue;
    ++mutual;
    const std::vector<RobotPlan> plans = plans_of(scene);
    INFO("scene " << i << " of seed 83");
    CHECK(gives_way(plans[0]) != gives_way(plans[1]));
  }
  CHECK(mutual > 50);
}

TEST_CASE("of three in a corridor the one that comes alone gives way to the two") {
  HeadOn scene({-0.35, 0.0}, {0.0, 0.0});
  add_yellow(scene.world, scene.targets, 2, {0.3, 0.0}, {-2.0, 0.0});
  const std::vector<RobotPlan> plans = plans_of(scene);
  REQUIRE(plans.size() == 3);
  CHECK(gives_way(plans[0]));
  CHECK_FALSE(gives_way(plans[1]));
  CHECK(plans == plans_of(scene));
}

TEST_CASE("nobody gives way to one who is where he wants to be, or is one of a crowd") {
  HeadOn stays({-0.6, 0.0}, {0.0, 0.0});
  stays.targets.targets[1].pose.position_m = {0.0, 0.0};
  const std::vector<RobotPlan> plans = plans_of(stays);
  CHECK(plans[0].plan.status == PlanStatus::unreachable);
  CHECK_FALSE(gives_way(plans[0]));

  WorldState ring;
  Targets targets;
  add_yellow(ring, targets, 0, {0.0, 0.0}, {2.0, 0.0});
  for (std::uint16_t i = 1; i <= 8; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / 8;
    const Vec2 out(std::cos(angle_rad), std::sin(angle_rad));
    add_yellow(ring, targets, i, 0.3 * out, 2.0 * out);
  }
  TeamPlanner planner(Team::yellow, {});
  const std::vector<RobotPlan> enclosed = planner.plan(division_b(), ring, targets).plans;
  CHECK(enclosed[0].plan.status == PlanStatus::unreachable);
  for (const RobotPlan& plan : enclosed) CHECK_FALSE(gives_way(plan));
}

}  // namespace regista
