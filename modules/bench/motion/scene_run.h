// Plays a set piece in the closed loop: when each robot arrived, against the least time of the straight way, who
// touched whom, and how those that cannot arrive wait.
#pragma once

#include <optional>
#include <vector>

#include "modules/bench/motion/loop_config.h"
#include "modules/bench/motion/motion_scene.h"
#include "sim/contacts.h"

namespace regista::bench {

/// Nearer than this to the target is there; as in sim/random_targets.h.
inline constexpr double kArrival_m = 0.05;
/// How long before a scene's end the waiting is looked at.
inline constexpr double kWaiting_s = 3.0;

/// One robot that the system drives.
struct Arrival {
  RobotId robot;
  double straight_s = 0.0;          ///< time-optimal drive of the distance, from rest to rest, within the limits
  std::optional<double> arrived_s;  ///< since the beginning; none within the scene's time
  double waited_m = 0.0;            ///< mean distance to the target in the last kWaiting_s, where not arrived
  double waiting_mps = 0.0;         ///< root mean square of its speed meanwhile
};

struct SceneScore {
  std::vector<Arrival> arrivals;
  ContactCounts contacts;
  double ended_s = 0.0;  ///< when all had arrived, or the scene's limit
  LoopVerdict verdict;
};

/// Seconds a robot needs for that distance from rest to rest along a straight line.
double straight_drive_s(double distance_m, const RobotLimits& limits);

/// `look` is called after every tick. Throws ConfigError and UnknownPlanner.
SceneScore play_scene(const MotionScene& scene, const SystemChoice& system, const std::string& preset,
                      std::uint64_t seed, const std::function<void(const ClosedLoop&)>& look = {});

}  // namespace regista::bench
