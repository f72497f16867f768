// What the DVG paper published: the rows are those printed, hang together, and stand above the measured ones.
#include <catch2/catch.hpp>

#include "modules/bench/paper/comparison.h"
#include "modules/bench/paper/dvg_drives.h"

namespace regista::bench {
namespace {

double printed_mean(const std::string& table, const std::string& what, const std::string& who,
                    const std::string& where = "") {
  for (const PublishedRow& row : load_published("dvg_published.toml", table).rows) {
    if (row.what == what && row.who == who && row.where == where) return row.mean;
  }
  FAIL("no row " << what << ", " << who << " in " << table);
  return 0.0;
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
      CHECK(printed_mean(row.table, row.what, "dvg", kDynamicScenarios.at(i)) == row.dvg[i]);
      CHECK(printed_mean(row.table, row.what, "rrt", kDynamicScenarios.at(i)) == row.rrt[i]);
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

}  // namespace
}  // namespace regista::bench
