// Counts one team's contacts during a run: among its own robots, those of them that opponents pushed it into, how long
// bodies touch, and contacts with opponents with the fault.
#pragma once

#include <map>
#include <vector>

#include "sim/simulator.h"

namespace regista::bench {

/// A contact within this time after an opponent, or a team-mate it had pushed, touched one of the two counts as
/// the opponent's push.
inline constexpr Duration kPushMemory{1'000'000};

struct ContactTally {
  std::int64_t own = 0;         ///< between two robots of the team
  std::int64_t own_pushed = 0;  ///< of these, soon after an opponent's push
  double own_touching_s = 0.0;  ///< summed over pairs
  std::int64_t opponent = 0;
  double opponent_touching_s = 0.0;
  std::int64_t at_fault = 0;         ///< contacts with opponents, ours alone or shared guilt
  std::int64_t at_fault_pushed = 0;  ///< of these, soon after another push of an opponent

  ContactTally& operator+=(const ContactTally& other);
  bool operator==(const ContactTally&) const = default;
};

class ContactWatch {
 public:
  ContactWatch(Team team, double robot_radius_m) : team_(team), robot_radius_m_(robot_radius_m) {}

  /// To be called often, at the least once per kContactsKept contacts; touching time is counted in steps of dt_s.
  void observe(const Simulator& simulator, const WorldState& truth, double dt_s);

  const ContactTally& tally() const { return tally_; }

 private:
  struct Touch {
    RobotId first, second;
  };
  void begin(const Contact& contact);
  bool was_pushed(RobotId robot, Time now) const;

  Team team_;
  double robot_radius_m_;
  std::int64_t seen_ = 0;
  std::vector<Touch> touching_;
  std::map<RobotId, Time> pushed_at_;  ///< our robots: when they were last pushed
  ContactTally tally_;
};

}  // namespace regista::bench
