// The shared graph remembers pure functions and nothing else.
#include "planning/graph/shared_graph.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "planning/graph/samples.h"
#include "planning/registry.h"
#include "tests/support/planning_worlds.h"

namespace regista::graph {
namespace {

std::vector<NodeId> all_nodes(SharedGraph& graph) {
  std::vector<NodeId> nodes;
  for (ObstacleIndex i = 0; i < graph.field().size(); ++i) {
    const SharedGraph::Samples samples = graph.samples(i);
    for (NodeId node = samples.first; node < samples.first + samples.count; ++node) nodes.push_back(node);
  }
  return nodes;
}

std::vector<ObstacleIndex> copied(std::span<const ObstacleIndex> list) { return {list.begin(), list.end()}; }

}  // namespace

TEST_CASE("what the graph remembers is what the field says, in both directions") {
  std::mt19937_64 random(11);
  SharedGraph graph;
  for (int world = 0; world < 20; ++world) {
    graph.reset(testing::random_field(random, 12));
    const std::vector<NodeId> nodes = all_nodes(graph);
    for (int round = 0; round < 2; ++round) {
      for (const NodeId from : nodes) {
        std::vector<ObstacleIndex> covering;
        graph.field().covering(graph.position(from), covering);
        REQUIRE(copied(graph.covering(from)) == covering);
        for (const NodeId to : nodes) {
          if (to == from) continue;
          std::vector<ObstacleIndex> expected;
          graph.field().blockers(graph.position(std::min(from, to)), graph.position(std::max(from, to)), expected);
          REQUIRE(copied(graph.blockers(from, to)) == expected);
        }
      }
    }
  }
}

TEST_CASE("an answer does not depend on who asked before") {
  std::mt19937_64 random(12);
  for (const PlannerEntry& entry : planners()) {
    const std::unique_ptr<Planner> planner = entry.make({});
    SharedGraph shared;
    for (int world = 0; world < 60; ++world) {
      const ObstacleField field = testing::random_field(random, static_cast<std::size_t>(world));
      shared.reset(field);
      std::vector<PlanRequest> requests;
      requests.reserve(11);
      for (int robot = 0; robot < 11; ++robot) requests.push_back(testing::random_request(random, field));
      for (PlanRequest& request : requests) request.budget.iterations = 200;
      std::vector<Plan> alone;
      alone.reserve(requests.size());
      for (const PlanRequest& request : requests) alone.push_back(entry.make({})->plan(field, request));
      CAPTURE(entry.name, world);
      for (std::size_t i = 0; i < requests.size(); ++i) {
        const Plan plan = planner->plan(shared, requests[i]);
        REQUIRE(plan == alone[i]);
      }
      for (std::size_t i = requests.size(); i-- > 0;) {
        const Plan plan = planner->plan(shared, requests[i]);
        REQUIRE(plan == alone[i]);
      }
    }
  }
}

TEST_CASE("adding an obstacle never opens an edge between nodes that were there before") {
  std::mt19937_64 random(13);
  for (int world = 0; world < 50; ++world) {
    const ObstacleField field = testing::random_field(random, 10);
    std::vector<Obstacle> more(field.obstacles().begin(), field.obstacles().end());
    more.push_back(testing::random_obstacle(random, field.bounds()));
    SharedGraph before(field);
    SharedGraph after(ObstacleField(field.bounds(), more));
    const std::vector<NodeId> old_nodes = all_nodes(before);
    const std::vector<NodeId> new_nodes = all_nodes(after);
    const auto same = [&](NodeId old_node) {
      return std::find_if(new_nodes.begin(), new_nodes.end(),
                          [&](NodeId node) { return after.position(node) == before.position(old_node); });
    };
    for (const NodeId from : old_nodes) {
      for (const NodeId to : old_nodes) {
        const auto new_from = same(from);
        const auto new_to = same(to);
        if (from == to || new_from == new_nodes.end() || new_to == new_nodes.end()) continue;
        if (after.blockers(*new_from, *new_to).empty()) REQUIRE(before.blockers(from, to).empty());
      }
    }
  }
}

namespace {

enum class Change { none, one_moves, one_comes, one_goes, sign_of_zero, all_move };

/// The next frame's obstacles, and whatever the change is, all of them valid.
void change(std::mt19937_64& random, const Bounds& bounds, Change change, std::vector<Obstacle>& obstacles) {
  const auto any = [&] { return random() % obstacles.size(); };
  switch (change) {
    case Change::none:
      break;
    case Change::one_moves:
      obstacles[any()] = testing::random_obstacle(random, bounds);
      break;
    case Change::one_comes:
      obstacles.push_back(testing::random_obstacle(random, bounds));
      break;
    case Change::one_goes:
      if (obstacles.size() > 1) obstacles.erase(obstacles.begin() + static_cast<std::ptrdiff_t>(any()));
      break;
    case Change::sign_of_zero:
      obstacles[0] = disc({std::signbit(obstacles[0].a.x()) ? 0.0 : -0.0, 0.0}, 0.3);
      break;
    case Change::all_move:
      for (Obstacle& obstacle : obstacles) obstacle = testing::random_obstacle(random, bounds);
      break;
  }
}

/// Of all nodes and edges; asking changes neither graph's content.
void require_same_content(SharedGraph& kept, SharedGraph& fresh) {
  const std::vector<NodeId> nodes = all_nodes(fresh);
  REQUIRE(all_nodes(kept) == nodes);
  for (const NodeId from : nodes) {
    REQUIRE(kept.position(from) == fresh.position(from));
    REQUIRE(copied(kept.covering(from)) == copied(fresh.covering(from)));
    for (const NodeId to : nodes) {
      if (to != from) REQUIRE(copied(kept.blockers(from, to)) == copied(fresh.blockers(from, to)));
    }
  }
}

}  // namespace

TEST_CASE("a graph that goes on from frame to frame equals one built anew, and so do the answers") {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    std::mt19937_64 random(seed);
    const ObstacleField first = testing::random_field(random, 8);
    std::vector<Obstacle> obstacles(first.obstacles().begin(), first.obstacles().end());
    SharedGraph kept;
    for (int frame = 0; frame < 12; ++frame) {
      const auto kind = static_cast<Change>(random() % 6);
      change(random, first.bounds(), kind, obstacles);
      const ObstacleField field(first.bounds(), obstacles);
      if (frame % 2 == 0) {
        kept.reset(field);
      } else {
        kept.reset(field.bounds(), obstacles);
      }
      CAPTURE(seed, frame, static_cast<int>(kind));
      for (const char* name : {"visibility_sampling", "tangent"}) {
        const std::unique_ptr<Planner> planner = make_planner(name);
        for (int robot = 0; robot < 4; ++robot) {
          const PlanRequest request = testing::random_request(random, field);
          const Plan plan = planner->plan(kept, request);
          REQUIRE(plan == planner->plan(field, request));
        }
      }
      if (frame % 3 != 0) continue;  // else everything is known from the first frame on
      SharedGraph fresh(field);
      require_same_content(kept, fresh);
    }
  }
}

TEST_CASE("nothing is forgotten while nothing moves") {
  const std::vector<Obstacle> obstacles{disc({-2, 0}, 0.5), disc({2, 0}, 0.5)};
  SharedGraph graph(ObstacleField({{5, 5}}, obstacles));
  graph.blockers(graph.samples(0).first, graph.samples(1).first);
  const GraphPicture before = graph.picture();
  graph.note_leg({0, 0}, {1, 1}, false);
  graph.reset({{5, 5}}, obstacles);
  CHECK(graph.picture().nodes == before.nodes);
  CHECK(graph.picture().edges == before.edges);
  graph.reset({{5, 6}}, obstacles);
  CHECK(graph.picture().nodes.empty());
}

TEST_CASE("the order of obstacles changes no length between two nodes of the graph") {
  std::mt19937_64 random(16);
  for (int world = 0; world < 50; ++world) {
    const ObstacleField field = testing::random_field(random, 10);
    SharedGraph graph(field);
    SharedGraph reversed(
        ObstacleField(field.bounds(), std::vector<Obstacle>(field.obstacles().rbegin(), field.obstacles().rend())));
    const auto other = [&](NodeId node) {
      const auto obstacle = static_cast<ObstacleIndex>(node / kSamplesMax);
      const auto last = static_cast<ObstacleIndex>(field.size() - 1);
      return static_cast<NodeId>(reversed.samples(last - obstacle).first + node % kSamplesMax);
    };
    CAPTURE(world);
    const std::vector<NodeId> nodes = all_nodes(graph);
    REQUIRE(all_nodes(reversed).size() == nodes.size());
    for (const NodeId from : nodes) {
      REQUIRE(reversed.position(other(from)) == graph.position(from));
      REQUIRE(reversed.covering(other(from)).size() == graph.covering(from).size());
      for (const NodeId to : nodes) {
        if (to != from) REQUIRE(reversed.blockers(other(from), other(to)).empty() == graph.blockers(from, to).empty());
      }
    }
  }
}

TEST_CASE("the picture shows what was evaluated") {
  SharedGraph graph(ObstacleField({{5, 5}}, {disc({-2, 0}, 0.5), disc({2, 0}, 0.5)}));
  CHECK(graph.picture().nodes.empty());
  const NodeId left = graph.samples(0).first;
  CHECK(graph.picture().nodes.size() == 4);
  const NodeId right = graph.samples(1).first;
  graph.blockers(right, left);  // both on the +x side of their discs: the right disc is in the way
  graph.blockers(right + 1, left + 1);
  const GraphPicture picture = graph.picture();
  REQUIRE(picture.nodes.size() == 8);
  CHECK(picture.edges == std::vector<GraphEdge>{{0, 4, true}, {1, 5, false}});
}

TEST_CASE("the table of edges grows and forgets") {
  EdgeMemo memo;
  for (int round = 0; round < 3; ++round) {
    for (std::uint32_t i = 0; i < 3000; ++i) memo.insert(i, i + 1, {i, round == 0 ? 1U : 2U});
    CHECK(memo.size() == 3000);
    for (std::uint32_t i = 0; i < 3000; ++i) {
      const BlockerList* found = memo.find(i + 1, i);
      REQUIRE(found != nullptr);
      REQUIRE(found->begin == i);
      REQUIRE(memo.find(i, i + 2) == nullptr);
    }
    memo.clear();
    CHECK(memo.find(1, 2) == nullptr);
    CHECK(memo.size() == 0);
  }
}

}  // namespace regista::graph
