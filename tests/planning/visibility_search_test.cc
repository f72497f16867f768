// The lazy search against Dijkstra on the whole graph it claims to have searched.
#include "planning/graph/visibility_search.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>

#include "planning/graph/samples.h"
#include "planning/planner.h"
#include "planning/planners/visibility_sampling.h"
#include "tests/support/planning_oracles.h"
#include "tests/support/planning_worlds.h"

namespace regista::graph {
namespace {

Query query_of(const PlanRequest& request) { return {request.start, request.goal, request.ignored, 1, {}, {}}; }

std::vector<Vec2> marked_graph(const ObstacleField& field, const PlanRequest& request,
                               std::span<const ObstacleIndex> marked) {
  std::vector<Vec2> samples, nodes{request.start, request.goal};
  for (const ObstacleIndex obstacle : marked) append_samples(field, obstacle, samples);
  std::copy_if(samples.begin(), samples.end(), std::back_inserter(nodes),
               [&](const Vec2& sample) { return field.is_free(sample, request.ignored); });
  return nodes;
}

}  // namespace

TEST_CASE("the path is the shortest over the samples of the marked obstacles") {
  std::mt19937_64 random(14);
  VisibilitySearch search;
  SharedGraph graph;
  int found_count = 0;
  std::vector<ObstacleIndex> straight_blockers;
  for (int world = 0; world < 1000; ++world) {
    const ObstacleField field = testing::random_field(random, static_cast<std::size_t>(world % 40));
    const PlanRequest request = testing::random_free_request(random, field);
    if (!field.is_free(request.start, request.ignored) || !field.is_free(request.goal, request.ignored)) continue;
    graph.reset(field);
    std::vector<Vec2> path;
    Query query = query_of(request);
    straight_blockers.clear();
    if (world % 2 == 0) field.blockers(request.start, request.goal, straight_blockers);
    std::erase_if(straight_blockers, [&](ObstacleIndex i) { return is_ignored(i, request.ignored); });
    query.straight_blockers = straight_blockers;
    const bool found = search.find(graph, query, path) == VisibilitySearch::End::goal;
    const std::vector<Vec2> nodes = marked_graph(field, request, search.marked());
    const std::optional<double> expected = testing::shortest_length(field, nodes, request.ignored);
    CAPTURE(world);
    REQUIRE(found == expected.has_value());
    REQUIRE(path.front() == request.start);
    if (!found) continue;
    ++found_count;
    REQUIRE(path.back() == request.goal);
    REQUIRE(length_of(path) == Approx(*expected).epsilon(1e-12));
  }
  CHECK(found_count > 500);
}

TEST_CASE("who is there already has found the way") {
  SharedGraph graph(ObstacleField({{5, 5}}, {disc({0, 0}, 0.3)}));
  VisibilitySearch search;
  std::vector<Vec2> path;
  CHECK(search.find(graph, {{-3, 0}, {-3, 0}, {}, 1, {}, {}}, path) == VisibilitySearch::End::goal);
  CHECK(search.marked().empty());
}

TEST_CASE("only obstacles in the way are marked") {
  const ObstacleField field({{5, 5}}, {disc({0, 0}, 0.3), disc({0, 3}, 0.3), disc({-4, -4}, 0.3)});
  SharedGraph graph(field);
  VisibilitySearch search;
  std::vector<Vec2> path;
  REQUIRE(search.find(graph, {{-3, 0}, {3, 0}, {}, 1, {}, {}}, path) == VisibilitySearch::End::goal);
  CHECK(std::vector<ObstacleIndex>(search.marked().begin(), search.marked().end()) == std::vector<ObstacleIndex>{0});
  REQUIRE(search.find(graph, {{-3, 1}, {3, 1}, {}, 1, {}, {}}, path) == VisibilitySearch::End::goal);
  CHECK(search.marked().empty());
  CHECK(path.size() == 2);
}

TEST_CASE("a covered sample marks what covers it") {
  // The second disc blocks no useful edge, but it covers the uppermost sample of the first.
  const ObstacleField field({{5, 5}}, {disc({0, 0}, 0.3), disc({0, 0.6}, 0.3), disc({0, 3}, 0.3)});
  SharedGraph graph(field);
  VisibilitySearch search;
  std::vector<Vec2> path;
  REQUIRE(search.find(graph, {{-3, 0.05}, {3, 0.05}, {}, 1, {}, {}}, path) == VisibilitySearch::End::goal);
  CHECK(std::vector<ObstacleIndex>(search.marked().begin(), search.marked().end()) == std::vector<ObstacleIndex>{0, 1});
}

TEST_CASE("the order of obstacles changes no length") {
  std::mt19937_64 random(15);
  VisibilitySampling planner;
  for (int world = 0; world < 500; ++world) {
    const ObstacleField field = testing::random_field(random, static_cast<std::size_t>(world % 50));
    PlanRequest request = testing::random_request(random, field);
    request.ignored.clear();
    std::vector<Obstacle> reversed(field.obstacles().rbegin(), field.obstacles().rend());
    const Plan plan = planner.plan(field, request);
    const Plan other = planner.plan(ObstacleField(field.bounds(), reversed), request);
    CAPTURE(world);
    REQUIRE(plan.status == other.status);
    if (plan.status == PlanStatus::ok) REQUIRE(plan.length_m == Approx(other.length_m).epsilon(1e-12));
  }
}

TEST_CASE("a search that takes long and has no way says that there is none") {
  // Both ends in two rings each, so that there is enough to try.
  std::vector<Obstacle> obstacles;
  for (const Vec2& centre : {Vec2(-3, 0), Vec2(3, 0)}) {
    for (const double radius_m : {1.0, 1.2}) {
      for (const Obstacle& piece : testing::ring_around(centre, radius_m)) obstacles.push_back(piece);
    }
  }
  PlanRequest request;
  request.start = {-3, 0};
  request.goal = {3, 0};
  SharedGraph graph(ObstacleField(testing::test_bounds(), obstacles));
  VisibilitySearch search;
  std::vector<Vec2> path;
  REQUIRE(search.find(graph, query_of(request), path) == VisibilitySearch::End::no_way);
  CHECK(path.front() == request.start);
  const Plan plan = VisibilitySampling().plan(graph, request);
  CHECK(plan.status == PlanStatus::unreachable);
  CHECK(plan.reason == "obstacles close every way");
}

TEST_CASE("what is found does not depend on which end is called the start") {
  std::mt19937_64 random(18);
  VisibilitySearch search;
  int hard_count = 0;
  for (int world = 0; world < 60; ++world) {
    std::vector<Obstacle> discs;
    discs.reserve(400);
    for (int i = 0; i < 400; ++i) discs.push_back(disc(testing::random_point(random, testing::test_bounds()), 0.21));
    const ObstacleField field(testing::test_bounds(), discs);
    const PlanRequest request = testing::random_free_request(random, field);
    if (!field.is_free(request.start) || !field.is_free(request.goal)) continue;
    PlanRequest back = request;
    back.ignored.clear();
    std::swap(back.start, back.goal);
    SharedGraph graph(field);
    std::vector<Vec2> path;
    Query query = query_of(back);
    const bool found_back = search.find(graph, query, path) == VisibilitySearch::End::goal;
    std::swap(query.start, query.goal);
    CAPTURE(world);
    REQUIRE((search.find(graph, query, path) == VisibilitySearch::End::goal) == found_back);
    const std::optional<double> expected =
        testing::shortest_length(field, marked_graph(field, back, search.marked()), {});
    REQUIRE(expected.has_value() == found_back);
    if (!found_back) continue;
    REQUIRE(length_of(path) == Approx(expected.value_or(0.0)).epsilon(1e-12));
    hard_count += search.marked().size() > 30 ? 1 : 0;
  }
  CHECK(hard_count > 5);
}

TEST_CASE("the reason is why the search ended, even when the time is up by the moment of the answer") {
  // A millimetre between any two neighbours: a way, but none over samples.
  std::vector<Obstacle> ring = testing::ring_around({3, 0}, 1.0);
  for (Obstacle& piece : ring) piece.radius_m = 0.1245;
  const ObstacleField field(testing::test_bounds(), ring);
  int questions = 0;
  int last_in_time = 1000;
  const std::function<bool()> out_of_time = [&] { return ++questions > last_in_time; };
  PlanRequest request;
  request.start = {-3, 0};
  request.goal = {3, 0};
  request.budget.out_of_time = &out_of_time;
  Query query = query_of(request);
  query.budget = request.budget;
  VisibilitySearch search;
  SharedGraph graph(field);
  std::vector<Vec2> path;
  REQUIRE(search.find(graph, query, path) == VisibilitySearch::End::no_samples);
  REQUIRE(questions > 0);
  last_in_time = questions;
  questions = 0;
  CHECK(VisibilitySampling().plan(field, request).reason == "no way over the samples");
  last_in_time -= 1;
  questions = 0;
  CHECK(VisibilitySampling().plan(field, request).reason == "the time was spent");
}

}  // namespace regista::graph
