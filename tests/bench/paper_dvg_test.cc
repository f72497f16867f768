// `regista bench paper dvg-*`: every table runs, its rows are those printed, its scenarios make sense, and the parts
// that are pure do what they say.
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "modules/bench/paper/comparison.h"
#include "modules/bench/paper/dvg_dynamic.h"
#include "modules/bench/paper/dvg_entrant.h"
#include "modules/bench/paper/dvg_groups.h"
#include "modules/bench/paper/paper.h"
#include "planning/planners/dvg_region.h"
#include "tests/support/temporary_folder.h"

namespace regista::bench {
namespace {

constexpr std::array kStatic{"dvg_connections", "dvg_worst_dvg", "dvg_worst_rrt", "dvg_mixed", "dvg_stoppage"};
constexpr std::array kDynamic{"dvg_dynamic_1", "dvg_dynamic_2"};

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, const std::string& extension) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == extension) files.push_back(entry.path());
  }
  return files;
}

double printed_mean(const std::string& table, const std::string& what, const std::string& who,
                    const std::string& where = "") {
  for (const PublishedRow& row : load_published("dvg_published.toml", table).rows) {
    if (row.what == what && row.who == who && row.where == where) return row.mean;
  }
  FAIL("no row " << what << ", " << who << " in " << table);
  return 0.0;
}

TEST_CASE("every table of the DVG paper runs, and leaves finite numbers and plots") {
  std::size_t tables = 0;
  for (const PaperTable& table : paper_tables()) {
    if (!table.name.starts_with("dvg-")) continue;
    ++tables;
    INFO(table.name);
    const TemporaryFolder folder;
    Run run;
    run.out = folder.path("out");
    PaperOptions options;
    options.samples = 3;
    REQUIRE(table.run(options, run) == 0);
    const auto csv = files_in(run.out, ".csv");
    REQUIRE(csv.size() >= 1);
    for (const auto& file : csv) {
      std::size_t measured = 0;
      for (const std::string& line : lines_of(file)) {
        if (line.starts_with("#")) continue;
        for (const std::string& cell : cells_of(line)) {
          INFO(line);
          CHECK_FALSE((cell == "nan" || cell == "-nan" || cell == "inf" || cell == "-inf"));
          measured += cell == "measured" ? 1U : 0U;
        }
      }
      CHECK(measured >= 2);
    }
    const auto pictures = files_in(run.out, ".png");
    CHECK(pictures.size() >= 1);
    CHECK(files_in(run.out, ".svg").size() == pictures.size());
    for (const auto& picture : pictures) CHECK(std::filesystem::file_size(picture) > 0);
  }
  CHECK(tables == 14);
}

TEST_CASE("same seed, same drives and lengths") {
  const TemporaryFolder folder;
  PaperOptions options;
  options.samples = 2;
  for (const char* name : {"dvg-table9", "dvg-table11"}) {
    std::vector<std::vector<std::string>> rows;
    for (const char* out : {"one", "other"}) {
      Run run;
      run.out = folder.path(std::string(name) + out);
      run.seed = 7;
      REQUIRE(find_paper_table(name)->run(options, run) == 0);
      auto& lines = rows.emplace_back(lines_of(files_in(run.out, ".csv").at(0)));
      std::erase_if(lines, [](const std::string& line) { return line.starts_with("#"); });
    }
    CHECK(rows[0] == rows[1]);
  }
}

TEST_CASE("the published rows are those printed") {
  struct Static {
    const char* table;
    double time_ms[2], length_m[2], safety_m[2];
  };
  const std::array kRows{Static{"table4", {6.50, 1.52}, {7.58, 7.93}, {7.84, 10.96}},
                         Static{"table5", {1.38, 8.86}, {12.94, 14.58}, {4.42, 6.40}},
                         Static{"table6", {0.94, 1.13}, {9.02, 9.41}, {1.65, 4.29}},
                         Static{"table7", {1.92, 3.79}, {3.65, 4.38}, {3.14, 3.88}}};
  const std::array kWho{"dvg", "rrt"};
  for (const Static& row : kRows) {
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(printed_mean(row.table, "time", kWho.at(i)) == row.time_ms[i]);
      CHECK(printed_mean(row.table, "length", kWho.at(i)) == row.length_m[i]);
      CHECK(printed_mean(row.table, "safety", kWho.at(i)) == row.safety_m[i]);
    }
  }
  CHECK(printed_mean("table1", "time", "dvg, no limit") == 6.65);
  CHECK(printed_mean("table1", "time", "dvg") == 3.14);
  CHECK(printed_mean("table1", "length", "dvg, no limit") == 6.72);
  CHECK(printed_mean("table1", "length", "dvg") == 7.15);
  CHECK(printed_mean("table2", "time", "dvg") == 7.39);
  CHECK(printed_mean("table2", "time", "dvg, grouped") == 1.53);
  CHECK(printed_mean("table2", "length", "dvg") == 8.27);
  CHECK(printed_mean("table2", "length", "dvg, grouped") == 8.24);
  CHECK(printed_mean("table2", "safety", "dvg") == 8.60);
  CHECK(printed_mean("table2", "safety", "dvg, grouped") == 9.53);
  struct Dynamic {
    const char *table, *what;
    double dvg[2], rrt[2];
  };
  const std::array kDrives{Dynamic{"table8", "planning", {6.80, 1.49}, {7.12, 2.36}},
                           Dynamic{"table9", "recalculated", {13.09, 5.79}, {34.08, 6.93}},
                           Dynamic{"table10", "navigation", {5.98, 5.30}, {5.89, 5.40}},
                           Dynamic{"table11", "collisions", {2.10, 0.89}, {2.12, 0.74}}};
  for (const Dynamic& row : kDrives) {
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(printed_mean(row.table, row.what, "dvg", kDynamic.at(i)) == row.dvg[i]);
      CHECK(printed_mean(row.table, row.what, "rrt", kDynamic.at(i)) == row.rrt[i]);
    }
  }
  CHECK(printed_mean("table12", "failures", "dvg", "dvg_worst_dvg") == 29.5);
  CHECK(printed_mean("table12", "left", "dvg", "dvg_worst_dvg") == 1.40);
  CHECK(printed_mean("table12", "failures", "rrt", "dvg_worst_dvg") == 0.0);
  CHECK(printed_mean("table12", "left", "rrt", "dvg_worst_dvg") == 0.01);
  CHECK(printed_mean("table12", "failures", "dvg", "dvg_worst_rrt") == 0.0);
  CHECK(printed_mean("table12", "left", "dvg", "dvg_worst_rrt") == 0.0);
  CHECK(printed_mean("table12", "failures", "rrt", "dvg_worst_rrt") == 25.5);
  CHECK(printed_mean("table12", "left", "rrt", "dvg_worst_rrt") == 3.05);
}

TEST_CASE("published rows hang together: the mean lies between minimum and maximum") {
  for (const char* table : {"table1", "table2", "table3", "table4", "table5", "table6", "table7", "table8", "table9",
                            "table10", "table11", "table12", "figure22", "figure23"}) {
    const Published published = load_published("dvg_published.toml", table);
    CHECK(published.samples == 200);
    CHECK_FALSE(published.rows.empty());
    for (const PublishedRow& row : published.rows) {
      INFO(table << ", " << row.what << ", " << row.who);
      if (row.min) CHECK(*row.min <= row.mean);
      if (row.max) CHECK(row.mean <= *row.max);
    }
  }
  CHECK_THROWS_WITH(load_published("dvg_published.toml", "table99"), Catch::Contains("table99"));
}

TEST_CASE("static scenarios: robots do not stand in each other, ends are free, the straight line is not") {
  for (const char* name : kStatic) {
    const DvgScenario scenario = load_dvg_scenario(name);
    const ObjectsQuery query = query_of(scenario);
    const World world = world_of(query);
    CHECK_FALSE(scenario.rebuilt.empty());
    CHECK(query.objects.size() == scenario.robots.size() + (scenario.ball ? 1 : 0));
    for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
      INFO(name << ", robot " << i);
      CHECK(is_inside(scenario.robots[i], world.bounds));
      for (std::size_t j = 0; j < i; ++j) CHECK((scenario.robots[i] - scenario.robots[j]).norm() >= 0.18);
    }
    const ObstacleField field(world.bounds, world.obstacles);
    INFO(name);
    CHECK(field.is_free(scenario.start));
    CHECK(field.is_free(scenario.goal));
    CHECK_FALSE(field.is_free(scenario.start, scenario.goal));
  }
  const DvgScenario worst = load_dvg_scenario("dvg_worst_dvg");
  CHECK(worst.robots.size() == 15);
  const dvg::ActiveRegion region(worst.start, worst.goal, 1.0);
  for (const Vec2& robot : worst.robots) {
    CHECK(region.is_reached_by(dvg::octagon(robot, dvg::kRobotObject_m).vertices()));
  }
  CHECK(load_dvg_scenario("dvg_worst_rrt").rrt_samples == 5000);
  CHECK(load_dynamic_scenario("dvg_dynamic_1").obstacles.size() == 7);
  CHECK(load_dynamic_scenario("dvg_dynamic_2").obstacles.size() == 5);
  CHECK_THROWS_WITH(load_dvg_scenario("no_such_scenario"), Catch::Contains("no_such_scenario"));
}

TEST_CASE("obstacles of the dynamic scenarios all cross the line and leave the goal free") {
  for (const char* name : kDynamic) {
    const DynamicScenario scenario = load_dynamic_scenario(name);
    for (const Crossing& crossing : scenario.obstacles) {
      CHECK(cross(scenario.goal - scenario.start, crossing.a - scenario.start) *
                cross(scenario.goal - scenario.start, crossing.b - scenario.start) <
            0.0);
      for (const Vec2& end : {scenario.start, scenario.goal}) {
        CHECK((nearest_on_segment(end, crossing.a, crossing.b) - end).norm() > dvg::kRobotObject_m);
      }
    }
  }
}

TEST_CASE("an obstacle goes to and fro at its speed") {
  const Crossing crossing{{0.0, -1.0}, {0.0, 1.0}};
  CHECK(place_of(crossing, 2.0, 0.0, 0.0).y() == Approx(-1.0));
  CHECK(place_of(crossing, 2.0, 0.0, 0.25).y() == Approx(-0.5));
  CHECK(place_of(crossing, 2.0, 0.0, 1.25).y() == Approx(0.5));
  CHECK(place_of(crossing, 2.0, 0.0, 2.0).y() == Approx(-1.0));
  CHECK(place_of(crossing, 2.0, 0.5, 0.0).y() == Approx(1.0));
  for (double time_s = 0.0; time_s < 10.0; time_s += 0.01) {
    const Vec2 step = place_of(crossing, 2.0, 0.3, time_s + 0.01) - place_of(crossing, 2.0, 0.3, time_s);
    CHECK(step.norm() <= 0.02 + 1e-12);
  }
}

std::vector<Vec2> straight(std::span<const dvg::Object>, const Vec2& from) { return {from, {5.0, 0.0}}; }

TEST_CASE("a drive alone takes the time of a trapezoid, and none recalculates") {
  const DynamicScenario empty{"", "", {-5.0, 0.0}, {5.0, 0.0}, 2.5, {}};
  const Drive alone = drive(empty, {}, straight);
  // 10 m at 2.5 m/s, and half of the time of speeding up with 3 m/s² and of braking with 4 m/s².
  CHECK(alone.arrived);
  CHECK(alone.navigation_s == Approx(10.0 / 2.5 + 2.5 / 3.0 / 2.0 + 2.5 / 4.0 / 2.0).margin(0.1));
  CHECK(alone.recalculated == 0);
  CHECK(alone.collisions == 0);
}

TEST_CASE("a drive through an obstacle: one collision, a new path asked for in every frame until it is passed") {
  const DynamicScenario one{"", "", {-5.0, 0.0}, {5.0, 0.0}, 2.5, {{{0.0, 0.0}, {0.0, 0.0}}}};
  const Drive through = drive(one, std::vector<double>{0.0}, straight);
  CHECK(through.arrived);
  CHECK(through.collisions == 1);
  CHECK(through.recalculated > 100);
  const DynamicScenario beside{"", "", {-5.0, 0.0}, {5.0, 0.0}, 2.5, {{{0.0, 0.1}, {0.0, 0.1}}}};
  const Drive near = drive(beside, std::vector<double>{0.0}, straight);
  CHECK(near.collisions == 1);    // bodies touch at 0.18 m
  CHECK(near.recalculated == 0);  // the path is crossed at 0.09 m only
  CHECK_THROWS_AS(drive(one, {}, straight), std::invalid_argument);
}

TEST_CASE("collisions half a second apart count again, and no path means standing") {
  // Stands on the start: the robot, which gets no path, is in contact all the time.
  const DynamicScenario blocked{"", "", {0.0, 0.0}, {5.0, 0.0}, 2.5, {{{0.0, 0.1}, {0.0, 0.1}}}};
  const Drive none = drive(blocked, std::vector<double>{0.0}, [](auto, const Vec2&) { return std::vector<Vec2>{}; });
  CHECK_FALSE(none.arrived);
  CHECK(none.collisions == Approx(120).margin(1));  // a minute
}

TEST_CASE("safety is the sum of distances, bodies touch below 180 mm") {
  const std::vector<Vec2> path{{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}};
  const std::vector<dvg::Object> objects{{{2.0, 0.5}, 0.24}, {{5.0, 2.0}, 0.24}, {{-3.0, 4.0}, 0.24}};
  CHECK(safety_m(objects, path) == Approx(0.5 + 1.0 + 5.0));
  CHECK_FALSE(touches_robot(objects, path));
  CHECK(touches_robot(std::vector<dvg::Object>{{{2.0, 0.17}, 0.24}}, path));
}

TEST_CASE("groups join by way of others") {
  const std::vector<Vec2> robots{{0.0, 0.0}, {3.0, 0.0}, {0.8, 0.0}, {0.4, 0.0}, {3.5, 0.0}};
  CHECK(group_sizes(robots, 0.5) == std::vector<std::size_t>{3, 1, 1});
  CHECK(group_sizes(robots, 0.51) == std::vector<std::size_t>{3, 2});
  CHECK(group_sizes(robots, 5.0) == std::vector<std::size_t>{5});
  CHECK(group_sizes({}, 1.0).empty());
}

TEST_CASE("a spent budget ends every entrant, and one without limit reaches the goal") {
  const ObjectsQuery query = query_of(load_dvg_scenario("dvg_worst_dvg"));
  for (const auto& entrant : dvg_and_rrt_and_ours()) {
    INFO(entrant->name());
    const Attempt whole = entrant->plan(query, 1, 0.0);
    REQUIRE(whole.reached);
    CHECK(whole.path.front() == query.start);
    CHECK(whole.path.back() == query.goal);
    Checker checker;
    entrant->check(query, whole, checker);
    CHECK(checker.checked() == 1);
    CHECK(checker.faults() == 0);
  }
  for (const auto& entrant : {published_dvg("dvg", {}), published_rrt("rrt", {})}) {
    INFO(entrant->name());
    CHECK_FALSE(entrant->plan(query, 1, 1e-3).reached);
  }
}

TEST_CASE("a published row stands right above the measured one") {
  Published published;
  published.samples = 200;
  published.units = {{"time", "ms"}};
  published.rows = {{"", "time", "dvg", 1.0, 0.5, 0.2, 3.0}, {"", "time", "rrt", 2.0, {}, {}, {}}};
  const Table table = comparison("t", published, {{"", "time", "ours", {0.1}, 0}, {"", "time", "rrt", {4.0, 6.0}, 1}});
  std::vector<std::string> order;
  for (const auto& row : table.rows)
    order.push_back(std::get<std::string>(row[1]) + " " + std::get<std::string>(row[2]));
  CHECK(order == std::vector<std::string>{"dvg published", "rrt published", "rrt measured", "ours measured"});
  CHECK(std::get<double>(table.rows[2][3]) == 5.0);
}

TEST_CASE("tables are found by name, and the list has a line for each") {
  CHECK(find_paper_table("dvg-table4") != nullptr);
  CHECK(find_paper_table("dvg-table13") == nullptr);
  std::ostringstream out;
  print_list(paper_tables(), out);
  const std::string text = out.str();
  CHECK(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) == paper_tables().size());
}

}  // namespace
}  // namespace regista::bench
