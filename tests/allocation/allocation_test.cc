// Planning a frame again and again asks the heap for nothing: every allocation of this program is counted.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <new>

#include "planning/registry.h"
#include "tests/support/planning_worlds.h"

namespace {

// The one global: operator new has no arguments of ours.
long allocations = 0;

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace regista {
namespace {

struct Scene {
  ObstacleField field;
  PlanRequest request;
};

/// Free and covered ends, up to 44 obstacles of all kinds.
std::vector<Scene> scenes() {
  std::mt19937_64 random(3);
  std::vector<Scene> all;
  for (std::size_t i = 0; i < 2000; ++i) {
    ObstacleField field = testing::random_field(random, i % 45);
    PlanRequest request = testing::random_request(random, field);
    all.push_back({std::move(field), std::move(request)});
  }
  return all;
}

/// Allocations while all scenes are planned; the answers' reasons are text and not counted.
long allocations_of(Planner& planner, graph::SharedGraph& graph, const std::vector<Scene>& all) {
  Plan plan;
  plan.path.reserve(1000);
  plan.reason.reserve(1000);
  const long before = allocations;
  for (const Scene& scene : all) {
    graph.reset(scene.field.bounds(), scene.field.obstacles());
    planner.plan(graph, scene.request, plan);
  }
  return allocations - before;
}

}  // namespace

TEST_CASE("allocations are counted") {
  const long before = allocations;
  std::vector<int> memory(100);
  CHECK(memory.size() == 100);
  CHECK(allocations > before);
}

TEST_CASE("after warming up, a query of the graph planners allocates nothing") {
  const std::vector<Scene> all = scenes();
  for (const char* name : {"tangent", "visibility_sampling"}) {
    const std::unique_ptr<Planner> planner = make_planner(name);
    graph::SharedGraph graph;
    const long cold = allocations_of(*planner, graph, all);
    const long warm = allocations_of(*planner, graph, all);
    CAPTURE(name);
    CHECK(cold > 0);
    CHECK(warm <= 2);  // the reserved answer itself
  }
}

}  // namespace regista
