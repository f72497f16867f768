// The heights at which things are drawn, so that what matters more hides what matters less.
#pragma once

namespace regista::layers {

// Software renderers compute depth in half precision: closer layers flicker through each other.
constexpr double kStep_m = 0.03;

constexpr double kStrip_m = 0 * kStep_m;
constexpr double kGrass_m = 1 * kStep_m;
constexpr double kGraph_m = 2 * kStep_m;
constexpr double kFieldLine_m = 3 * kStep_m;
constexpr double kLink_m = 4 * kStep_m;  ///< robot to target, where there is no path
constexpr double kPathEdge_m = 5 * kStep_m;
constexpr double kPath_m = 6 * kStep_m;
constexpr double kTarget_m = 7 * kStep_m;
constexpr double kRobotEdge_m = 8 * kStep_m;
constexpr double kRobot_m = 9 * kStep_m;
constexpr double kRobotFront_m = 10 * kStep_m;
constexpr double kBallEdge_m = 11 * kStep_m;
constexpr double kBall_m = 12 * kStep_m;
constexpr double kNumberEdge_m = 13 * kStep_m;
constexpr double kNumber_m = 14 * kStep_m;

}  // namespace regista::layers
