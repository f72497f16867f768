// One tiny run of each bench: it ends well and leaves its tables and plots.
#include <catch2/catch.hpp>
#include <fstream>

#include "modules/bench/anytime_bench.h"
#include "modules/bench/bench.h"
#include "modules/bench/ompl_grid_bench.h"
#include "modules/bench/scale_bench.h"
#include "modules/bench/static_bench.h"
#include "modules/bench/team_bench.h"
#include "planning/uniform.h"
#include "tests/bench/bench_run.h"

namespace regista::bench {
namespace {

TEST_CASE("bench static") {
  const BenchRun bench;
  StaticOptions options;
  options.queries = 30;
  options.for_s = 5.0;
  CHECK(run_static(options, bench.run) == 0);
  CHECK(bench.rows("static") == planners().size());
  CHECK(bench.has_plot("static_time"));
  CHECK(bench.has_plot("static_quality"));
  options.planners = {"no_such_planner"};
  CHECK_THROWS_AS(run_static(options, bench.run), UnknownPlanner);
}

TEST_CASE("bench team") {
  const BenchRun bench;
  TeamOptions options;
  options.frames = 5;
  CHECK(run_team(options, bench.run) == 0);
  CHECK(bench.rows("team") >= 1);
}

TEST_CASE("bench anytime") {
  const BenchRun bench;
  AnytimeOptions options;
  options.queries = 3;
  options.times_ms = {0.3, 3.0};
  options.planners = {"rrt"};
  CHECK(run_anytime(options, bench.run) == 0);
  CHECK(bench.rows("anytime") == 4);
  CHECK(bench.has_plot("anytime_success"));
  CHECK(bench.has_plot("anytime_length"));
}

TEST_CASE("bench scale") {
  const BenchRun bench;
  ScaleOptions options;
  options.queries = 20;
  options.frames = 2;
  options.obstacles = {21, 60};
  options.robots = {11, 30};
  options.crowds = {60};
  options.for_s = 5.0;
  CHECK(run_scale(options, bench.run) == 0);
  for (const char* name : {"scale_obstacles", "scale_fleet", "scale_crowd"}) {
    INFO(name);
    CHECK(bench.rows(name) >= 1);
    CHECK(bench.has_plot(name));
  }
}

TEST_CASE("bench ompl-grid") {
  const BenchRun bench;
  GridOptions options;
  options.queries = 5;
  options.grid = bench.folder.path("grid.toml");
  std::ofstream(options.grid) << "time_us = [2000]\nsimplify = [true]\n[rrt_connect]\nrange_m = [0.5, 1.0]\n";
  CHECK(run_ompl_grid(options, bench.run) == 0);
  CHECK(bench.rows("ompl_grid") == 2);
  CHECK(bench.rows("ompl_grid_ratio") >= 1);
}

TEST_CASE("a scene is a function of its seed, and robots do not stand in each other") {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    std::mt19937_64 first(seed), second(seed);
    const TeamScene scene = eleven_against_eleven_team(first);
    CHECK(scene.world.obstacles == eleven_against_eleven_team(second).world.obstacles);
    CHECK(scene.requests.size() == 11);
    REQUIRE(scene.world.obstacles.size() >= 30);  // 22 robots, two areas, six walls
    for (std::size_t i = 1; i < 22; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        INFO("seed " << seed << ", robots " << i << " and " << j);
        CHECK((scene.world.obstacles[i].a - scene.world.obstacles[j].a).norm() >= 0.18);
      }
    }
  }
}

TEST_CASE("fleets keep the density of 11 against 11") {
  std::mt19937_64 random(1);
  for (const std::size_t count : {5U, 21U, 200U}) {
    const TeamScene scene = fleet(random, count, count);
    const Vec2 extent = 2.0 * scene.world.bounds.half_extent_m;
    CHECK(static_cast<double>(count) / (extent.x() * extent.y()) == Approx(21.0 / 108.0));
    CHECK(scene.requests.size() == count);
    CHECK(scene.requests.back().ignored == std::vector<std::size_t>{count - 1});
  }
}

}  // namespace
}  // namespace regista::bench
