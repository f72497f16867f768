// Planted faults are found, counted, and make the bench fail.
#include <catch2/catch.hpp>

#include "modules/bench/bench.h"
#include "tests/support/temporary_folder.h"

namespace regista::bench {
namespace {

/// A disc in the way; start and goal on both sides of it.
struct Fixture {
  World world{{Vec2(6.0, 4.5)}, {disc({0.0, 0.0}, 0.5)}};
  PlanRequest request;
  Plan plan;
  Fixture() {
    request.start = {-2.0, 0.0};
    request.goal = {2.0, 0.0};
    plan.status = PlanStatus::ok;
    set_path({{-2.0, 0.0}, {0.0, 1.5}, {2.0, 0.0}});
  }
  void set_path(std::vector<Vec2> path) {
    plan.path = std::move(path);
    plan.length_m = length_of(plan.path);
  }
  std::string fault() const { return fault_of(world, request, plan); }
};

TEST_CASE("a path that keeps the laws has no fault") {
  Fixture f;
  CHECK(f.fault() == "");
  f.plan.status = PlanStatus::not_found;  // whose path need not lead anywhere
  f.plan.path.clear();
  CHECK(f.fault() == "");
}

TEST_CASE("every kind of fault is found") {
  Fixture f;
  SECTION("through an obstacle") {
    f.set_path({{-2.0, 0.0}, {2.0, 0.0}});
    CHECK_THAT(f.fault(), Catch::Contains("inside obstacle 0"));
    f.request.ignored = {0};
    CHECK(f.fault() == "");
  }
  SECTION("a hair inside") {
    f.set_path({{-2.0, 0.5 - 1e-6}, {2.0, 0.5 - 1e-6}});
    f.request.start = f.plan.path.front();
    f.request.goal = f.plan.path.back();
    CHECK_THAT(f.fault(), Catch::Contains("inside obstacle 0"));
  }
  SECTION("out of bounds") {
    f.set_path({{-2.0, 0.0}, {0.0, 4.6}, {2.0, 0.0}});
    CHECK_THAT(f.fault(), Catch::Contains("out of bounds"));
  }
  SECTION("another start, another goal") {
    f.request.start = {-2.5, 0.0};
    CHECK_THAT(f.fault(), Catch::Contains("start"));
    f.request.start = {-2.0, 0.0};
    f.request.goal = {2.5, 0.0};
    CHECK_THAT(f.fault(), Catch::Contains("goal"));
    f.plan.goal_moved = true;
    CHECK(f.fault() == "");
  }
  SECTION("a wrong length") {
    f.plan.length_m *= 0.999;
    CHECK_THAT(f.fault(), Catch::Contains("long"));
  }
  SECTION("no path") {
    f.plan.path.clear();
    CHECK(f.fault() != "");
  }
}

TEST_CASE("the first leg of a moved start crosses what covers the start, nothing else") {
  Fixture f;
  f.request.start = {0.0, 0.2};
  f.plan.start_moved = true;
  f.set_path({{0.0, 0.2}, {0.0, 0.5}, {2.0, 1.5}, {2.0, 0.0}});
  CHECK(f.fault() == "");
  f.world.obstacles.push_back(disc({0.0, 0.6}, 0.2));
  CHECK_THAT(f.fault(), Catch::Contains("obstacle 1"));
  f.world.obstacles.pop_back();
  f.plan.start_moved = false;
  CHECK_THAT(f.fault(), Catch::Contains("obstacle 0"));
}

TEST_CASE("a planted fault is counted for its planner and makes the exit status 1") {
  const TemporaryFolder folder;
  Run run;
  run.out = folder.path("out");
  const Report report(run);
  Fixture f;
  Checker checker;
  CHECK(checker.check("honest", f.world, f.request, f.plan));
  CHECK(report.finish(checker) == 0);
  f.set_path({{-2.0, 0.0}, {2.0, 0.0}});
  CHECK_FALSE(checker.check("liar", f.world, f.request, f.plan));
  CHECK(checker.checked() == 2);
  CHECK(checker.faults() == 1);
  CHECK(checker.faults("liar") == 1);
  CHECK(checker.faults("honest") == 0);
  REQUIRE(checker.texts().size() == 1);
  CHECK_THAT(checker.texts().front(), Catch::Contains("liar"));
  CHECK(report.finish(checker) == 1);
}

}  // namespace
}  // namespace regista::bench
