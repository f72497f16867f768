// The tables of the sampling papers: each runs with a handful of samples and gives finite numbers, its data load, and
// what is printed as published comes from them.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "modules/bench/bench.h"
#include "modules/bench/paper/irrt_table1.h"
#include "modules/bench/paper/paper.h"
#include "modules/bench/paper/sbp_sweep.h"
#include "modules/bench/paper/vis_race.h"
#include "modules/bench/paper/vis_scenes.h"
#include "planning/clearance.h"
#include "tests/support/temporary_folder.h"

namespace regista::bench {
namespace {

/// One run of a table with few samples and the CSVs it leaves.
struct PaperRun {
  TemporaryFolder folder;
  Run run;
  int status = -1;

  PaperRun(std::string_view name, std::size_t samples) {
    run.out = folder.path("out");
    const PaperTable* table = find_paper_table(name);
    REQUIRE(table != nullptr);
    status = table->run(PaperOptions{samples, 1000.0}, run);
  }

  /// Rows of cells, head first. No cell of ours but the findings' has a comma in it.
  std::vector<std::vector<std::string>> csv(const std::string& name) const {
    std::ifstream file(run.out / (name + ".csv"));
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(file, line);) {
      if (line.starts_with("#")) continue;
      rows.emplace_back();
      std::string cell;
      bool is_quoted = false;
      for (const char c : line) {
        if (c == '"') is_quoted = !is_quoted;
        if (c == ',' && !is_quoted) {
          rows.back().push_back(std::exchange(cell, ""));
        } else if (c != '"') {
          cell += c;
        }
      }
      rows.back().push_back(cell);
    }
    return rows;
  }

  std::string cell(const std::string& name, const std::string& row, const std::string& column,
                   std::size_t key_column = 0) const {
    const auto rows = csv(name);
    REQUIRE(rows.size() > 1);
    const auto found = std::find(rows.front().begin(), rows.front().end(), column);
    REQUIRE(found != rows.front().end());
    for (const auto& cells : rows) {
      if (cells[key_column] == row) return cells[static_cast<std::size_t>(found - rows.front().begin())];
    }
    FAIL("no row " << row);
    return "";
  }

  bool has_plot(const std::string& name) const {
    return std::filesystem::file_size(run.out / (name + ".svg")) > 0 &&
           std::filesystem::file_size(run.out / (name + ".png")) > 0;
  }
};

void check_numbers_are_finite(const PaperRun& paper, const std::string& name, std::size_t rows_wanted) {
  const auto rows = paper.csv(name);
  INFO(name);
  REQUIRE(rows.size() == rows_wanted + 1);
  for (const auto& cells : rows) {
    CHECK(cells.size() == rows.front().size());
    for (const std::string& cell : cells) {
      INFO(cell);
      CHECK(cell.find("nan") != 0);
      CHECK(cell.find("-nan") != 0);
      CHECK(cell.find("inf") != 0);
    }
  }
}

TEST_CASE("[SBP] figures 6 to 9 run") {
  const DataTable data(kSbpFile);
  const PaperRun batches("sbp-figures6-9", 3);
  CHECK(batches.status == 0);
  const DataTable figure = data.table("batches");
  check_numbers_are_finite(batches, "sbp-figures6-9",
                           figure.tables("planner").size() * figure.numbers("samples_per_batch").size());
  check_numbers_are_finite(batches, "sbp-figures6-9_findings", figure.tables("finding").size());
  CHECK(batches.has_plot("sbp-figure6"));

  const PaperRun times("sbp-figures7-8", 3);
  CHECK(times.status == 0);
  const DataTable other = data.table("times");
  check_numbers_are_finite(times, "sbp-figures7-8", other.tables("planner").size() * other.numbers("times_ms").size());
  check_numbers_are_finite(times, "sbp-figures7-8_findings", other.tables("finding").size());
  CHECK(times.cell("sbp-figures7-8", "tangent", "success [%]") == "100");
  CHECK(std::stod(times.cell("sbp-figures7-8", "tangent", "ratio mean [x]")) == 1.0);
  CHECK(times.has_plot("sbp-figure7"));
  CHECK(times.has_plot("sbp-figure8"));
}

TEST_CASE("[SBP] figure 10: the ideal tracker arrives as soon as its speed allows") {
  const PaperRun paper("sbp-figure10", 1);
  CHECK(paper.status == 0);
  const DataTable data(kSbpFile);
  check_numbers_are_finite(paper, "sbp-figure10", data.table("tracking").tables("planner").size());
  CHECK(paper.has_plot("sbp-figure10"));
  // The shortest way, planned anew at each of its points, stays the shortest way; arcs are polylines 0.1 % longer.
  CHECK(std::stod(paper.cell("sbp-figure10", "tangent", "way / shortest [x]")) == Approx(1.0).epsilon(1e-3));
  CHECK(paper.cell("sbp-figure10", "tangent", "arrived [%]") == "100");
}

TEST_CASE("[IRRT] table I: the published row is the data's, the map is passable and blocks the straight line") {
  const PaperRun paper("irrt-table1", 3);
  CHECK(paper.status == 0);
  check_numbers_are_finite(paper, "irrt-table1", 7);
  CHECK(paper.has_plot("irrt-table1"));
  CHECK(paper.has_plot("irrt-figure9"));
  CHECK(std::stod(paper.cell("irrt-table1", "apf", "published time", 1)) == 102.477935);
  CHECK(std::stod(paper.cell("irrt-table1", "irrt_smooth", "published length", 1)) == 708.567281);
  CHECK(paper.cell("irrt-table1", "tangent", "published time", 1).empty());

  const Scene scene = irrt_scene();
  CHECK(scene.world.obstacles.size() == 11);
  std::size_t blocking = 0;
  for (const Obstacle& obstacle : scene.world.obstacles) {
    CHECK(is_free(scene.request.start, obstacle));
    CHECK(is_free(scene.request.goal, obstacle));
    blocking += is_free(scene.request.start, scene.request.goal, obstacle) ? 0U : 1U;
  }
  CHECK(blocking == 5);  // as the data file says
  const double way_m = (scene.request.goal - scene.request.start).norm();
  CHECK(std::stod(paper.cell("irrt-table1", "tangent", "measured length [m]", 1)) > way_m);
}

TEST_CASE("[VIS] tables run, published numbers are the data's") {
  for (const auto& [name, single, star] :
       {std::tuple{"vis-wall", "0.411", "2.338"}, std::tuple{"vis-agents", "2.61", "0.43"}}) {
    const PaperRun paper(name, 5);
    CHECK(paper.status == 0);
    check_numbers_are_finite(paper, name, 6);
    CHECK(paper.has_plot(name));
    CHECK(paper.cell(name, "visibility_sampling_single", "published [ms]") == single);
    CHECK(paper.cell(name, "rrt_star", "published [ms]") == star);
    const double ratio = std::stod(paper.cell(std::string(name) + "_ratio", "published", "all: means [x]"));
    CHECK(ratio == Approx(std::stod(star) / std::stod(single)));
    check_numbers_are_finite(paper, std::string(name) + "_ratio",
                             1 + 3 * 2);  // three RRT*, each with two budgets
  }
}

TEST_CASE("RRT* ends as soon as its path is no longer than that of visibility_sampling") {
  // Around a disc this large the samples are far from the tangents, which RRT* betters soon.
  Scene scene;
  scene.world = {{Vec2(4.5, 3.0)}, {disc({0.0, 0.0}, 1.0)}};
  scene.request.start = {-2.0, 0.1};
  scene.request.goal = {2.0, 0.1};
  std::vector<Racer> racers = racers_of(DataTable(kVisFile).table("wall"));
  Checker checker;
  constexpr double kLong_us = 60e6;
  REQUIRE(race(racers, scene, kLong_us, 0, checker));
  CHECK(checker.faults() == 0);
  for (const Racer& racer : racers) {
    INFO(racer.name);
    REQUIRE(racer.trials.size() == 1);
    CHECK(racer.trials.front().is_blocked);
    CHECK(racer.trials.front().reached);
    REQUIRE(racer.length_ratio.size() == 1);
    if (racer.until == Racer::Until::no_longer) CHECK(racer.length_ratio.front() <= 1.0 + 1e-6);
  }
  // With no time there is no path, and the run counts with the full budget.
  REQUIRE(race(racers, scene, 1e-3, 1, checker));
  REQUIRE(racers[3].trials.size() == 2);
  CHECK_FALSE(racers[3].trials.back().reached);
  const Table ratios = ratios_of(racers, "title", {1e3, 1e6});
  const double mark_us = 0.5 * (racers[0].trials[0].time_us + racers[0].trials[1].time_us);
  const double star_us = 0.5 * (racers[3].trials[0].time_us + 1e9);
  CHECK(std::get<double>(ratios.rows[2][4]) == Approx(star_us / mark_us));
}

TEST_CASE("[SBP] scenes are as described, and a function of their seed") {
  const SbpScenario scenario = sbp_scenario(DataTable(kSbpFile));
  CHECK(sbp_budget_us(DataTable(kSbpFile)) == Approx(1e6 / 300.0));
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    std::mt19937_64 first(seed), second(seed);
    const Scene scene = sbp_scene(scenario, first);
    const Scene same = sbp_scene(scenario, second);
    INFO("seed " << seed);
    CHECK(scene.world.obstacles == same.world.obstacles);
    CHECK(scene.request.start == same.request.start);
    REQUIRE(scene.world.obstacles.size() == 9);
    CHECK(scene.request.start.x() <= -1.5);
    CHECK(scene.request.goal.x() >= 1.5);
    for (const Obstacle& obstacle : scene.world.obstacles) {
      CHECK(obstacle.radius_m == Approx(0.18));
      CHECK(std::abs(obstacle.a.x()) <= 1.5);
      CHECK(is_free(scene.request.start, obstacle));
      CHECK(is_free(scene.request.goal, obstacle));
    }
  }
}

TEST_CASE("half of the scenes succeed from between the places of a curve on, along the logarithm") {
  Sweep sweep{"allowed time", "ms", {}};
  sweep.curves.emplace_back();
  for (const auto& [x, solved] : {std::pair{1.0, 0U}, std::pair{100.0, 10U}}) {
    SweepPoint point{x, 0.0, Contender{"a planner", nullptr}};
    point.blocked = 10;
    point.blocked_solved = solved;
    sweep.curves.back().push_back(std::move(point));
  }
  const Measurement measured = measurement_of(sweep);
  CHECK(measured("half_success_at", "a planner", 0.0).value() == Approx(10.0));
  CHECK(measured("success_blocked", "a planner", 100.0).value() == Approx(100.0));
  CHECK_FALSE(measured("length", "a planner", 1.0).has_value());
  CHECK_THROWS_AS(measured("length", "another planner", 1.0), std::runtime_error);
  CHECK_THROWS_AS(measured("no such quantity", "a planner", 1.0), std::runtime_error);
  sweep.curves.back().back().blocked_solved = 4;
  CHECK_FALSE(measured("half_success_at", "a planner", 0.0).has_value());
}

TEST_CASE("twelve agents: no two in each other, and the asker does not ignore the areas") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 50; ++i) {
    const Scene scene = agents_scene(6, random);
    REQUIRE(scene.world.obstacles.size() >= 14);  // twelve robots, two areas
    CHECK(scene.request.ignored.size() == 1);
    for (std::size_t a = 1; a < 12; ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        CHECK((scene.world.obstacles[a].a - scene.world.obstacles[b].a).norm() >= 0.18);
      }
    }
  }
}

TEST_CASE("data that make no sense are refused with file and key") {
  const DataTable data(kSbpFile);
  CHECK_THROWS_WITH(data.number("scenario"), Catch::Contains("sbp_figures.toml") && Catch::Contains("scenario"));
  CHECK_THROWS_WITH(data.table("scenario").count("length_m"), Catch::Contains("length_m"));
  CHECK_THROWS_WITH(data.table("scenario").point("no_such_key"), Catch::Contains("no_such_key"));
  CHECK_THROWS_AS(DataTable("no_such_file.toml"), std::runtime_error);
  const auto nothing = [](const std::string&, const std::string&, double) { return std::optional<double>(); };
  const Table table = findings_table("title", data.table("tracking").tables("finding"), nothing);
  CHECK(std::holds_alternative<std::monostate>(table.rows.front().back()));
  const auto five = [](const std::string&, const std::string& planner, double) {
    return std::optional<double>(planner == "bit_star" ? 4.0 : 5.0);
  };
  const Table decided = findings_table("title", data.table("tracking").tables("finding"), five);
  CHECK(std::get<std::string>(decided.rows[0].back()) == "yes");  // bit_star < rrt_star
  CHECK(std::get<std::string>(decided.rows[1].back()) == "no");   // fmt_star < rrt_star, equal
}

}  // namespace
}  // namespace regista::bench
