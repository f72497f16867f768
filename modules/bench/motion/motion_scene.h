// Set pieces in which robots are in each other's way: who stands where, who goes where, who drives whom.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "planning/targets.h"
#include "sim/formation.h"
#include "world_model/types/field.h"

namespace regista::bench {

/// still: nobody commands these robots; they may be pushed.
enum class SceneDriver { system, still, chaser };

struct MotionScene {
  std::string name;
  FieldGeometry field;
  std::vector<RobotPlacement> robots;
  std::array<Targets, 2> targets;                                               ///< by Team
  std::array<SceneDriver, 2> drivers{SceneDriver::system, SceneDriver::still};  ///< by Team
  double limit_s = 30.0;                                                        ///< the scene ends then at the latest

  explicit MotionScene(std::string scene_name);
  /// A robot that stands at `from` and, where it is driven, is to go to `to`.
  void add(Team team, const Vec2& from, const Vec2& to);
  void add(Team team, const Vec2& place) { add(team, place, place); }
};

/// Robots evenly on a circle around the centre, each to the opposite point; every other one blue where there are two
/// teams. The field is at the least division A's and large enough.
MotionScene circle_swap(std::size_t robots, double radius_m, bool two_teams);

/// Two robots from either end of a corridor to the other; there is no way around. Its walls are standing opponents, as
/// far apart as one and a half robots are wide: 45 mm on either side of one, so planning keeps 30.
MotionScene corridor();

/// Through the middle of eight team-mates that stand shoulder to shoulder around it and set off outwards at once.
MotionScene ring();

/// From the middle of the opponent's defence area, where it must not be, to the centre.
MotionScene defence_area();

/// To a target on which an opponent stands.
MotionScene occupied_target();

/// From the boards, past an opponent on the straight way, which presses the robot against them at full speed and does
/// not let go.
MotionScene pinned();

std::vector<MotionScene> swap_scenes();

}  // namespace regista::bench
