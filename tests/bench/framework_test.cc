// What benches are made of: numbers that can be checked by hand, and files that are there.
#include <catch2/catch.hpp>
#include <fstream>
#include <set>
#include <sstream>

#include "modules/bench/bench.h"
#include "modules/bench/grid.h"
#include "modules/bench/pacing.h"
#include "modules/bench/tool.h"
#include "tests/support/temporary_folder.h"

namespace regista::bench {
namespace {

std::vector<std::string> lines_of(const std::string& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST_CASE("a summary says what its sample says") {
  const Summary s = summarise({4.0, 1.0, 3.0, 2.0, 5.0}, 15);
  CHECK(s.count == 5);
  CHECK(s.failures == 15);
  CHECK(s.success() == Approx(0.25));
  CHECK(s.mean == Approx(3.0));
  CHECK(s.sigma == Approx(std::sqrt(2.5)));  // (4 + 1 + 0 + 1 + 4) / 4
  CHECK(s.min == 1.0);
  CHECK(s.p25 == 2.0);
  CHECK(s.p50 == 3.0);
  CHECK(s.p75 == 4.0);
  CHECK(s.p90 == 5.0);
  CHECK(s.max == 5.0);
}

TEST_CASE("percentiles are values that were measured, and the worst one shows") {
  std::vector<double> values;
  for (int i = 1; i <= 1000; ++i) values.push_back(i);
  const Summary s = summarise(values);
  CHECK(s.p99 == 990.0);
  CHECK(s.max == 1000.0);
  CHECK(summarise({}).count == 0);
  CHECK(summarise({}, 3).success() == 0.0);
  CHECK(summarise({7.0}).sigma == 0.0);
}

TEST_CASE("an exact power law is found again") {
  std::vector<Vec2> points;
  for (const double n : {21.0, 50.0, 100.0, 400.0, 1000.0}) points.emplace_back(n, 0.3 * std::pow(n, 0.6));
  const PowerLaw law = fit_power_law(points);
  CHECK(law.exponent == Approx(0.6).epsilon(1e-12));
  CHECK(law.factor == Approx(0.3).epsilon(1e-12));
  CHECK_THROWS_AS(fit_power_law(std::vector<Vec2>{{1.0, 2.0}}), std::invalid_argument);
  CHECK_THROWS_AS(fit_power_law(std::vector<Vec2>{{1.0, 2.0}, {0.0, 1.0}}), std::invalid_argument);
}

TEST_CASE("slow planners get every k-th query, so that all end in time") {
  const std::vector<double> query_s{1e-6, 1e-3, 1e-1};
  const std::vector<std::size_t> every = strides(query_s, 10000, 12.0);
  double needed_s = 0.0;
  for (std::size_t i = 0; i < query_s.size(); ++i) needed_s += 1e4 * query_s[i] / static_cast<double>(every[i]);
  CHECK(needed_s <= 12.0);
  CHECK(every[0] == 1);
  CHECK(every[1] >= 1);
  CHECK(every[2] > every[1]);
  CHECK(strides(query_s, 10000, 1e6) == std::vector<std::size_t>{1, 1, 1});
}

TEST_CASE("every planner is first in turn, and none is left out") {
  std::set<std::size_t> first;
  for (std::size_t round = 0; round < 4; ++round) {
    const std::vector<std::size_t> order = rotated(4, round);
    first.insert(order.front());
    CHECK(std::set<std::size_t>(order.begin(), order.end()).size() == 4);
  }
  CHECK(first.size() == 4);
}

TEST_CASE("a CSV tells its circumstances and every digit") {
  const TemporaryFolder folder;
  Table table{"a title", {{"planner"}, {"time", "us"}, {"queries"}}};
  table.add({std::string("a \"b\", c"), 1.0 / 3.0, count_cell(7)});
  table.add({std::string("d"), {}, std::int64_t{-1}});
  CHECK_THROWS_AS(table.add({std::string("e")}), std::invalid_argument);
  table.notes = {"a note"};
  Run run;
  run.seed = 42;
  run.command = "regista bench something";
  write_csv(table, record_of(run), folder.path("t.csv"));

  std::set<std::string> keys;
  std::vector<std::string> data;
  for (const std::string& line : lines_of(folder.path("t.csv"))) {
    if (line.starts_with("# ")) {
      keys.insert(line.substr(2, line.find(':') - 2));
    } else {
      data.push_back(line);
    }
  }
  for (const char* key : {"table", "command", "seed", "machine", "cores", "load", "compiler", "flags", "build type",
                          "commit", "date", "note"}) {
    INFO(key);
    CHECK(keys.count(key) == 1);
  }
  REQUIRE(data.size() == 3);
  CHECK(data[0] == "planner,time [us],queries");
  CHECK(data[1].starts_with("\"a \"\"b\"\", c\","));
  const std::string number = data[1].substr(data[1].find(",0.") + 1);
  CHECK(std::stod(number) == 1.0 / 3.0);  // not a digit lost
  CHECK(data[2] == "d,,-1");
  CHECK_THROWS(write_csv(table, {}, folder.path("missing/t.csv")));
}

TEST_CASE("a table stands in columns") {
  Table table{"title", {{"planner"}, {"time", "µs"}}};
  table.add({std::string("a"), 12345.678});
  table.add({std::string("longer"), 0.5});
  std::ostringstream out;
  print(table, out);
  CHECK(out.str() ==
        "title\n"
        "planner  time [µs]\n"
        "a            12346\n"
        "longer       0.500\n\n");
}

TEST_CASE("plots are drawn as SVG and PNG, with data and script beside them") {
  const TemporaryFolder folder;
  REQUIRE(run_tool(".", {"gnuplot", "--version"}).status == 0);
  Plot lines{"a \"title\"", {"x", "m", true}, {"y", "µs", true}};
  lines.series = {{"with_underscore", {{1.0, 1.0, std::pair{0.5, 2.0}}, {10.0, 100.0}}}, {"empty", {}}};
  Plot boxes{"boxes", {"planner"}, {"y", "µs"}};
  boxes.boxes = {{"a", summarise({1.0, 2.0, 3.0})}, {"b", summarise({4.0, 5.0, 9.0})}};
  for (const auto& [plot, name] : {std::pair{lines, "lines"}, std::pair{boxes, "boxes"}}) {
    draw(plot, folder.path(name));
    for (const char* ending : {".dat", ".gp", ".svg", ".png"}) {
      INFO(name << ending);
      CHECK(std::filesystem::file_size(folder.path(std::string(name) + ending)) > 0);
    }
  }
  CHECK_THROWS_AS(draw(Plot{}, folder.path("nothing")), PlotError);
}

TEST_CASE("a plot that cannot be drawn says so in one line, and the CSV stays") {
  const TemporaryFolder folder;
  Run run;
  run.out = folder.path("out");
  Report report(run);
  report.add("t", Table{"title", {{"a"}}});
  report.add("p", Plot{"no point", {"x"}, {"y"}});
  CHECK(report.finish(Checker{}) == 1);
  CHECK(std::filesystem::file_size(folder.path("out/t.csv")) > 0);
}

TEST_CASE("a grid is every combination of its values") {
  const TemporaryFolder folder;
  std::ofstream(folder.path("grid.toml")) << "time_us = [100, 200]\nsimplify = [false, true]\n"
                                             "[rrt_star]\nrange_m = [0.5, 1.0, 2.0]\ngoal_bias = [0.05]\n";
  const std::vector<Setting> settings = load_grid(folder.path("grid.toml"));
  CHECK(settings.size() == 2 * 2 * 3);
  std::set<std::string> texts;
  for (const Setting& setting : settings) texts.insert(setting.text() + " " + std::to_string(setting.time_us));
  CHECK(texts.size() == settings.size());
  std::ofstream(folder.path("bad.toml")) << "time_us = [100]\nsimplify = [false]\n[rrt_star]\nrnage_m = [0.5]\n";
  CHECK_THROWS_WITH(load_grid(folder.path("bad.toml")), Catch::Contains("bad.toml") && Catch::Contains("range_m"));
}

TEST_CASE("the shipped grid loads") {
  CHECK(load_grid(std::string(REGISTA_SOURCE_DIR) + "/modules/bench/data/ompl_grid.toml").size() > 100);
}

}  // namespace
}  // namespace regista::bench
