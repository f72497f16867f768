// Several graphs in one picture.
#include "planning/graph/graph_picture.h"

#include <catch2/catch.hpp>

namespace regista {

TEST_CASE("a graph comes into a picture whole or not at all") {
  GraphPicture picture;
  picture.world_sequence = 7;
  picture.nodes = {{0.0, 0.0}, {1.0, 0.0}};
  picture.edges = {{0, 1, false}};
  GraphPicture other;
  other.world_sequence = 8;
  other.nodes = {{2.0, 0.0}, {3.0, 0.0}};
  other.edges = {{1, 0, true}};
  CHECK(append(other, picture));
  CHECK(picture.world_sequence == 7);
  CHECK(picture.nodes.size() == 4);
  CHECK(picture.edges == std::vector<GraphEdge>{{0, 1, false}, {3, 2, true}});
  other.edges.assign(kEdgesInPicture - 1, {0, 1, false});
  const GraphPicture before = picture;
  CHECK_FALSE(append(other, picture));
  CHECK(picture == before);
  other.edges.pop_back();
  CHECK(append(other, picture));
  CHECK(picture.edges.size() == kEdgesInPicture);
}

}  // namespace regista
