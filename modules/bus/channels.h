// The channel names, each bound to the value it carries. One publisher per channel; see lcmtypes/README.md for who.
#pragma once

#include <string>

#include "control/velocity_command.h"
#include "modules/bus/service_values.h"
#include "planning/graph/graph_picture.h"
#include "planning/plan.h"
#include "planning/targets.h"
#include "world_model/types/game_state.h"
#include "world_model/types/vision_frame.h"
#include "world_model/types/world_state.h"

namespace regista {

/// A channel, or for subscribing a regular expression over channel names, of one value type.
template <class Value>
struct Channel {
  std::string name;
};

namespace channels {

inline std::string of(const char* base, Team team) { return std::string(base) + "." + letter(team); }

inline Channel<VisionFrame> vision() { return {"VISION"}; }
inline Channel<FieldAnnouncement> geometry() { return {"GEOMETRY"}; }
inline Channel<GameState> referee() { return {"REFEREE"}; }
inline Channel<WorldState> world_state() { return {"WORLD_STATE"}; }
inline Channel<WorldState> truth() { return {"TRUTH"}; }
inline Channel<Targets> targets(Team team) { return {of("TARGETS", team)}; }
inline Channel<RobotPlan> plan(RobotId robot) { return {"PLAN." + to_string(robot)}; }
inline Channel<RobotPlan> plans(Team team) { return {of("PLAN\\", team) + "[0-9]+"}; }
inline Channel<GraphPicture> graph(Team team) { return {of("GRAPH", team)}; }
inline Channel<TeamCommands> commands(Team team) { return {of("COMMANDS", team)}; }
inline Channel<Request> request() { return {"REQUEST"}; }
inline Channel<Reply> reply() { return {"REPLY"}; }
inline Channel<Timing> timing(const std::string& module) { return {"TIMING." + module}; }
inline Channel<Timing> timings() { return {"TIMING\\..*"}; }
inline Channel<ModuleStatus> status(const std::string& module) { return {"STATUS." + module}; }
inline Channel<ModuleStatus> statuses() { return {"STATUS\\..*"}; }

/// True for the channels that carry measured durations and process ids, which no two runs share.
inline bool is_measured(const std::string& channel) {
  return channel.starts_with("TIMING.") || channel.starts_with("STATUS.");
}

}  // namespace channels
}  // namespace regista
