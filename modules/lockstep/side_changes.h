// How often a team's robots change their minds about the side on which they pass an obstacle: counted from the plans
// themselves, whoever made them.
#pragma once

#include <map>
#include <optional>

#include "modules/bus/channels.h"
#include "modules/bus/mailbox.h"
#include "planning/obstacle_rules.h"

namespace regista {

/// Per minute and robot; 0 when nothing was observed.
struct SideChangeRate {
  double all = 0.0;
  double quick = 0.0;  ///< those that follow another one within 0.2 s: traffic does not turn that fast, noise does
};

class SideChanges {
 public:
  /// params are those the team plans with: they say where its obstacles are.
  SideChanges(Bus& bus, Team team, const PlanningParams& params);

  /// Changes of side per minute and robot, over the pairs of plans for consecutive world states and the same target.
  SideChangeRate rate() const;

 private:
  struct Followed {
    RobotPlan plan;
    std::optional<Time> changed;  ///< when the robot last changed sides on the way to this target
  };

  void judge(const RobotPlan& plan);
  void compare(Followed& followed, const RobotPlan& plan);

  Team team_;
  PlanningParams params_;
  std::uint64_t obstacles_sequence_ = 0;  ///< of the world state that obstacles_ is made from; 0: none
  TeamObstacles obstacles_;
  std::map<RobotId, Followed> followed_;
  std::int64_t changes_ = 0;
  std::int64_t quick_changes_ = 0;
  Duration observed_{};  ///< of all robots together
  Mailbox<FieldAnnouncement> geometry_;
  Mailbox<WorldState> world_;
  Listener<RobotPlan> plans_;
};

}  // namespace regista
