// Listens to everything that can be seen and keeps it as one ViewerScene; whoever draws or records asks for it.
#pragma once

#include <array>

#include "modules/bus/module.h"
#include "modules/viewer/duration_window.h"
#include "modules/viewer/viewer_scene.h"

namespace regista {

class ViewerModule : public Module {
 public:
  /// Called in tick() for every world state, in order, with the scene as it was when the state came in.
  using OnWorldState = std::function<void(const ViewerScene&)>;

  explicit ViewerModule(Bus& bus, OnWorldState on_world_state = {});

  /// What is to be drawn now: without plans and graphs that are older or newer than the world they would be drawn into.
  ViewerScene scene() const;

  /// Capture time of the newest world state, nullopt before the first.
  std::optional<Time> world_time() const;

  /// Field, world and the plans of every team that has targets have come in.
  bool complete() const;

  /// Anything has come in.
  bool heard() const { return heard_; }

  std::string note() const override;

 protected:
  bool has_input() const override { return fresh_; }
  void on_tick(Time now) override;

 private:
  struct TeamInput {
    TeamInput(ViewerModule& viewer, Bus& bus, Team team);
    Listener<Targets> targets;
    Listener<RobotPlan> plans;
    Listener<GraphPicture> graph;
    DurationWindow robot_times;
    DurationWindow team_times;
  };

  void hear() { heard_ = fresh_ = true; }
  void take(const WorldState& world);
  void take(const Timing& timing);
  TeamInput& input_of(Team team) { return team == Team::yellow ? yellow_ : blue_; }

  OnWorldState on_world_state_;
  ViewerScene latest_;  ///< all that came in, stale or not
  bool heard_ = false;
  bool fresh_ = false;
  bool field_known_ = false;
  std::optional<Time> world_arrived_;
  std::vector<ViewerScene> unrecorded_;
  Listener<FieldAnnouncement> geometry_;
  Listener<WorldState> world_;
  Listener<Timing> timings_;
  TeamInput yellow_;
  TeamInput blue_;
};

}  // namespace regista
