// `regista bench paper dvg-*`: every table runs, is found by name, gives the same rows for a seed, and its parts that
// are pure do what they say.
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "modules/bench/paper/dvg_entrant.h"
#include "modules/bench/paper/dvg_groups.h"
#include "modules/bench/paper/paper.h"
#include "tests/support/temporary_folder.h"

namespace regista::bench {
namespace {

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

TEST_CASE("tables are found by name, and the list has a line for each") {
  CHECK(find_paper_table("dvg-table4") != nullptr);
  CHECK(find_paper_table("dvg-table13") == nullptr);
  std::ostringstream out;
  print_list(paper_tables(), out);
  const std::string text = out.str();
  CHECK(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) == paper_tables().size());
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

}  // namespace
}  // namespace regista::bench
