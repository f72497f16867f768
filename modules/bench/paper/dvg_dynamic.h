// The dynamic test of Costa & Tonidandel (section 5): a robot drives from start to goal along a path that is planned
// anew whenever an obstacle crosses it, among obstacles that go to and fro at the robot's own top speed and know
// nothing of it. Pure: the planner comes as a function, times are measured in it.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "planning/planners/dvg_objects.h"

namespace regista::bench {

/// An obstacle goes between these points.
struct Crossing {
  Vec2 a = Vec2::Zero();
  Vec2 b = Vec2::Zero();
};

struct DynamicScenario {
  std::string title;
  std::string rebuilt;
  Vec2 start = Vec2::Zero();
  Vec2 goal = Vec2::Zero();
  double speed_mps = 2.5;  ///< of the obstacles, and the robot's top speed
  std::vector<Crossing> obstacles;
};

/// modules/bench/data/paper/<name>.toml. Throws std::runtime_error naming the file.
DynamicScenario load_dynamic_scenario(const std::string& name);

/// Where an obstacle is at that time when it begins `phase` (0 … 1) of its way there and back.
Vec2 place_of(const Crossing& crossing, double speed_mps, double phase, double time_s);

/// The robot's path from its place among the obstacles; empty where there is none.
using Replan = std::function<std::vector<Vec2>(std::span<const dvg::Object> objects, const Vec2& from)>;

struct Drive {
  bool arrived = false;       ///< within the time a run may take
  double navigation_s = 0.0;  ///< from leaving the start to standing at the goal
  std::size_t recalculated = 0;
  std::size_t collisions = 0;
};

/// The robot is an ideal tracker: it stays on the path whatever its corners, speeds up with 3 m/s², and brakes with
/// 4 m/s² so that it stands at the goal (the defaults of world_model/types/robot_limits.h); without a path it brakes on
/// the old one. Bodies pass through each other. A frame is 1/60 s: at each one the rest of the path is looked at; an
/// obstacle's centre within 90 mm of it asks for a new one. Collisions, centres nearer than 180 mm, are looked for four
/// times a frame, and one counts only 0.5 s after the one before. `phases` has one number per obstacle.
Drive drive(const DynamicScenario& scenario, std::span<const double> phases, const Replan& replan);

}  // namespace regista::bench
