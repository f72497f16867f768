// One game of `regista bench crowd`: our team to random targets among opponents of some kind, scored.
#pragma once

#include <string>
#include <vector>

#include "modules/bench/motion/contact_watch.h"
#include "modules/bench/motion/loop_config.h"

namespace regista::bench {

/// system: as we are. random: straight to random targets at up to 2 m/s, avoiding nobody. chaser: towards our nearest
/// robot at 3 m/s. none: nobody there, and our own robots pass through each other (PassThroughDriver).
enum class Opponents { system, random, chaser, none };

const char* name(Opponents opponents);
/// Throws std::invalid_argument naming the known ones.
Opponents opponents_of(const std::string& name);

struct CrowdGame {
  std::string division = "A";
  std::string preset = "noisy";
  Opponents opponents = Opponents::system;
};

struct CrowdScore {
  double minutes = 0.0;        ///< simulated
  double robot_minutes = 0.0;  ///< of our team
  std::int64_t reached = 0;    ///< targets, by our team
  ContactTally contacts;       ///< of our team
  std::vector<DriveTime> times;
  double cpu_s = 0.0;
  LoopVerdict verdict;

  CrowdScore& operator+=(const CrowdScore& other);
  /// Targets per minute of the team.
  double pace() const { return static_cast<double>(reached) / minutes; }
  double per_robot_minute(double count) const { return count / robot_minutes; }
};

/// We are yellow. Throws ConfigError and UnknownPlanner.
CrowdScore play_crowd(const CrowdGame& game, const SystemChoice& system, double minutes, std::uint64_t seed);

}  // namespace regista::bench
