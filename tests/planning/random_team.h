// Frames for the tests of a team's planning: two whole teams anywhere on the field, and a target for each of ours.
#pragma once

#include "planning/targets.h"
#include "tests/support/planning_worlds.h"
#include "world_model/types/world_state.h"

namespace regista::testing {

inline constexpr std::uint16_t kRobots = 11;

inline WorldState random_world(std::mt19937_64& random, std::uint64_t sequence) {
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

inline Targets random_targets(std::mt19937_64& random) {
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

}  // namespace regista::testing
