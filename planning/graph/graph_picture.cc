#include "planning/graph/graph_picture.h"

namespace regista {

bool append(const GraphPicture& other, GraphPicture& picture) {
  if (picture.edges.size() + other.edges.size() > kEdgesInPicture) return false;
  const auto first = static_cast<std::uint32_t>(picture.nodes.size());
  picture.nodes.insert(picture.nodes.end(), other.nodes.begin(), other.nodes.end());
  for (const GraphEdge& edge : other.edges) picture.edges.push_back({first + edge.from, first + edge.to, edge.blocked});
  return true;
}

}  // namespace regista
