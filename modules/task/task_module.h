// WORLD_STATE in, TARGETS of both teams out: the scenario's task, and orders from people ("task.goto"). Where the
// scenario or a person ("task.referee") states what the referee says, REFEREE out too.
#pragma once

#include <map>

#include "modules/bus/module.h"
#include "sim/task.h"

namespace regista {

class TaskModule : public Module {
 public:
  /// Throws std::invalid_argument as validate(scenario).
  TaskModule(Bus& bus, const Scenario& scenario);
  std::string note() const override;

  /// Targets the team has reached so far.
  std::int64_t reached(Team team) const;

 protected:
  bool has_input() const override { return world_.fresh(); }
  void on_tick(Time now) override;

 private:
  struct TeamTask {
    Team team = Team::yellow;
    Task task;
    std::map<std::uint16_t, Target> orders;  ///< go over the task's targets, until the next order
    std::optional<Time> published;           ///< when last
    Targets last;                            ///< what was published last
  };

  void publish_if_due(TeamTask& team, const WorldState& world, Time now);
  void publish_referee_if_due(Time now);
  std::string go_to(const Request& request);
  std::string release(const Request& request);
  std::string referee(const Request& request);

  Scenario scenario_;
  Mailbox<WorldState> world_;
  std::vector<TeamTask> teams_;
  std::optional<GameState> game_;          ///< what the referee says; empty: nothing
  std::optional<Time> referee_published_;  ///< when last; empty: what it says now is not published yet
};

}  // namespace regista
