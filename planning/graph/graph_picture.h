// The shared graph as a viewer draws it: plain points and edges, detached from the planning that made them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "world_model/types/geometry.h"
#include "world_model/types/robot_id.h"
#include "world_model/types/time.h"

namespace regista {

struct GraphEdge {
  std::uint32_t from = 0;  ///< index into nodes
  std::uint32_t to = 0;    ///< index into nodes
  bool blocked = false;    ///< by at least one obstacle; a robot that ignores it may still use the edge
  bool operator==(const GraphEdge&) const = default;
};

struct GraphPicture {
  Time captured{};  ///< capture time of the world it is made from
  Team team = Team::yellow;
  std::uint64_t world_sequence = 0;  ///< WorldState::sequence it is made from
  std::vector<Vec2> nodes;           ///< samples, and the ends of the tangents that were tested; metres
  std::vector<GraphEdge> edges;      ///< as far as any robot's search evaluated them
  bool operator==(const GraphPicture&) const = default;
};

/// No picture has more: it fits a datagram.
inline constexpr std::size_t kEdgesInPicture = 2000;

/// One more graph into the same picture, whose header stays. False, and nothing changes: together they have too many
/// edges.
bool append(const GraphPicture& other, GraphPicture& picture);

}  // namespace regista
