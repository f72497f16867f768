// A made-up scene with everything in it: eleven against eleven with plans, targets, graphs and times.
#pragma once

#include "modules/viewer/viewer_scene.h"

namespace regista {

/// Robots on two columns per team, every robot's target on the other half, a path with one bend between. Yellow Y0 at
/// (-5, -3.5), numbers counting up along y.
ViewerScene fake_scene();

/// The parts of it, for tests that build their own.
RobotState fake_robot(Team team, std::uint16_t number);
RobotPlan fake_plan(const RobotState& robot, const Target& target);
GraphPicture fake_graph(Team team, const FieldGeometry& field);

}  // namespace regista
