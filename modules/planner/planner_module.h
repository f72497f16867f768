// WORLD_STATE, GEOMETRY, TARGETS and, where one is heard, REFEREE in, one PLAN per robot of a team out, from the graph
// the team shares. The planner is swapped between ticks by the request "planner.use".
#pragma once

#include "modules/bus/module.h"
#include "modules/process/real_clock.h"
#include "planning/team_planner.h"

namespace regista {

struct PlannerModuleParams {
  std::string use{kDefaultPlanner};
  /// Targets older than this are none: the task repeats them ten times a second, and silence means stop.
  double targets_deadline_s = 1.0;
  PlanningParams planning;
  bool operator==(const PlannerModuleParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v("use", self.use, Range{}, "", "planner to begin with, see: regista planner list");
    v("targets_deadline_s", self.targets_deadline_s, Range{0.01, 1e6}, "s", "older targets are not planned for");
    PlanningParams::visit(self.planning, v);
  }
};

class PlannerModule : public Module {
 public:
  /// Throws UnknownPlanner when params name none of the registry.
  PlannerModule(Bus& bus, Team team, const PlannerModuleParams& params, Stopwatch stopwatch);
  std::string note() const override;

 protected:
  bool has_input() const override { return world_.fresh(); }
  void on_tick(Time now) override;

 private:
  /// What planning still waits for, or nullptr when it can begin.
  const char* waits_for() const;
  void publish_graph(const WorldState& world);

  Team team_;
  PlannerModuleParams params_;
  TeamPlanner planner_;
  Stopwatch stopwatch_;
  Mailbox<WorldState> world_;
  Mailbox<FieldAnnouncement> geometry_;
  Mailbox<Targets> targets_;
  Mailbox<GameState> referee_;
  SituationWatch situation_;
  std::optional<Time> graph_published_;
};

}  // namespace regista
