// WORLD_STATE, GEOMETRY, REFEREE and PLAN in, COMMANDS out. Ticks when the set of plans for the newest world state is
// complete, or at its deadline with the plans it has; brakes when plans or world go quiet.
#pragma once

#include <map>

#include "control/controller.h"
#include "modules/bus/module.h"
#include "modules/process/real_clock.h"

namespace regista {

struct ControllerModuleParams {
  /// How long to wait for the whole set of plans of a world state: most of a camera period, so that late plans delay a
  /// command but never cost one.
  double plan_wait_s = 0.008;
  ControlParams control;
  bool operator==(const ControllerModuleParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("plan_wait_s", self.plan_wait_s, Range{0.0, 1.0}, "s", "how long to wait for all plans of a world state");
    ControlParams::visit(self.control, v);
  }
};

class ControllerModule : public Module {
 public:
  ControllerModule(Bus& bus, Team team, const ControllerModuleParams& params, Stopwatch stopwatch);
  std::optional<Time> due() const override;
  std::string note() const override;

 protected:
  bool has_input() const override { return world_.fresh() && set_is_complete(); }
  void on_tick(Time now) override;

 private:
  struct KeptPlan {
    RobotPlan plan;
    Time arrived;
  };

  void keep(RobotPlan plan);
  bool set_is_complete() const;
  Time plans_due() const;
  Time brake_due() const;
  std::vector<RobotPlan> fresh_plans(Time now) const;
  void command(Time now);
  void brake(Time now);
  void publish(const TeamCommands& commands);

  Team team_;
  ControllerModuleParams params_;
  Controller controller_;
  Stopwatch stopwatch_;
  Mailbox<WorldState> world_;
  Mailbox<FieldAnnouncement> geometry_;
  Mailbox<GameState> referee_;
  SituationWatch situation_;
  Listener<RobotPlan> plan_listener_;
  std::map<std::uint16_t, KeptPlan> plans_;
  std::optional<Time> last_captured_;  ///< of the world the last command was made from
  std::optional<Time> braked_at_;      ///< last braking command since the world went quiet
  bool standing_ = true;               ///< our last command moves nothing: no need to go on braking
};

}  // namespace regista
