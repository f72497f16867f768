// Everything the viewer draws, as one plain value: filled by ViewerModule from messages or by hand, drawn by
// draw_scene() the same way into a window, a picture or a recording.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "planning/graph/graph_picture.h"
#include "planning/plan.h"
#include "planning/targets.h"
#include "world_model/types/field.h"
#include "world_model/types/world_state.h"

namespace regista {

/// Of the durations measured lately.
struct DurationSummary {
  std::int64_t p50_ns = 0;
  std::int64_t max_ns = 0;
  bool operator==(const DurationSummary&) const = default;
};

struct TeamScene {
  std::optional<Targets> targets;
  std::map<std::uint16_t, RobotPlan> plans;  ///< by the robot's number
  std::optional<GraphPicture> graph;
  std::optional<DurationSummary> planning_robot;  ///< planning time per robot
  std::optional<DurationSummary> planning_team;   ///< planning time per tick of the whole team
  bool operator==(const TeamScene&) const = default;
};

struct ViewerScene {
  FieldGeometry field;
  Time began{};  ///< capture time that the picture's clock counts from
  WorldState world;
  std::array<TeamScene, 2> teams;  ///< by Team
  std::string notice;              ///< one line for people, empty when all is well
  bool operator==(const ViewerScene&) const = default;

  TeamScene& of(Team team) { return teams[static_cast<std::size_t>(team)]; }
  const TeamScene& of(Team team) const { return teams[static_cast<std::size_t>(team)]; }
};

}  // namespace regista
