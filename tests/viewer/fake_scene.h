// A made-up scene with everything in it: eleven against eleven with plans, targets, graphs and times.
#pragma once

#include "modules/viewer/viewer_scene.h"

namespace regista {

/// Each team in its half, its numbers counting up along y; every robot's target across the field, its path with one
/// bend.
ViewerScene fake_scene();

/// The parts of it, for tests that build their own.
RobotState fake_robot(Team team, std::uint16_t number);
RobotPlan fake_plan(const RobotState& robot, const Target& target);
GraphPicture fake_graph(Team team, const FieldGeometry& field);

}  // namespace regista
