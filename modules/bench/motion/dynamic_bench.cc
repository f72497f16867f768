#include "modules/bench/motion/dynamic_bench.h"

#include <array>
#include <numeric>

#include "modules/bench/bench.h"
#include "modules/bench/motion/dynamic_drive.h"
#include "modules/bench/motion/parallel.h"
#include "modules/bench/motion/verdict.h"
#include "modules/bench/paper/dvg_drives.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

struct Quantity {
  const char* table;  ///< of the paper, and its published rows
  const char* what;
  double (*of)(const DynamicDrive& drive);
};

constexpr std::array kQuantities{
    Quantity{"8", "planning", [](const DynamicDrive& drive) { return drive.planning_ms; }},
    Quantity{"9", "recalculated", [](const DynamicDrive& drive) { return static_cast<double>(drive.crossed); }},
    Quantity{"10", "navigation", [](const DynamicDrive& drive) { return drive.navigation_s; }},
    Quantity{"11", "collisions", [](const DynamicDrive& drive) { return static_cast<double>(drive.collisions); }}};

/// All drives of one setting.
struct Row {
  std::string preset, scenario;
  SystemChoice system;
  std::string who;  ///< planner and safety
  std::vector<DynamicDrive> drives;
};

std::vector<Row> rows_of(const DynamicOptions& options) {
  const std::vector<std::string>& safety = options.safety;
  std::vector<Row> rows;
  for (const std::string& preset : options.presets) {
    for (const char* scenario : kDynamicScenarios) {
      for (const std::string& planner : options.planners) {
        for (const std::string& mode : safety) {
          rows.push_back({preset,
                          scenario,
                          {planner, mode, options.settings},
                          mode.empty() ? planner + ", system" : planner + ", " + mode,
                          std::vector<DynamicDrive>(options.drives)});
        }
      }
    }
  }
  return rows;
}

/// Every row meets the same obstacles.
void drive(std::vector<Row>& rows, const DynamicOptions& options, std::uint64_t seed) {
  std::map<std::string, DynamicScenario> scenarios;
  for (const char* name : kDynamicScenarios) scenarios.emplace(name, load_dynamic_scenario(name));
  in_parallel("dynamic", rows.size() * options.drives, options.jobs, [&](std::size_t i) {
    Row& row = rows[i / options.drives];
    const DynamicScenario& scenario = scenarios.at(row.scenario);
    const std::uint64_t drive_seed = mixed(seed, i % options.drives);
    std::mt19937_64 random(drive_seed);
    std::vector<double> phases(scenario.obstacles.size());
    for (double& phase : phases) phase = uniform(random);
    row.drives[i % options.drives] = drive_dynamic(scenario, phases, row.system, row.preset, drive_seed);
  });
}

std::vector<double> values_of(const Row& row, double (*of)(const DynamicDrive& drive)) {
  std::vector<double> values;
  for (const DynamicDrive& drive : row.drives) {
    if (drive.arrived) values.push_back(of(drive));
  }
  return values;
}

void add_quantity(Report& report, const Quantity& quantity, const std::string& preset, const std::vector<Row>& rows) {
  const Published published = load_published("dvg_published.toml", std::string("table") + quantity.table);
  std::vector<Sampled> sampled;
  for (const Row& row : rows) {
    if (row.preset != preset) continue;
    std::vector<double> values = values_of(row, quantity.of);
    const std::size_t lost = row.drives.size() - values.size();
    sampled.push_back({row.scenario, quantity.what, row.who, std::move(values), lost});
  }
  const std::string title = std::string("dynamic, table ") + quantity.table + " driven by the system, preset " + preset;
  report.add(std::string("dynamic_table") + quantity.table + "_" + preset, comparison(title, published, sampled));
  for (std::size_t i = 0; i < kDynamicScenarios.size(); ++i) {
    const Plot plot =
        boxes(title + ", " + kDynamicScenarios.at(i), kDynamicScenarios.at(i), quantity.what, published, sampled);
    if (plot.boxes.empty()) continue;
    report.add(std::string("dynamic_table") + quantity.table + "_" + preset + "_" + std::to_string(i + 1), plot);
  }
}

Table summary_table(const std::vector<Row>& rows) {
  Table table{"dynamic: the system among obstacles that cross at its own top speed",
              {{"preset"},
               {"scenario"},
               {"planner, safety"},
               {"drives"},
               {"not arrived"},
               {"planning", "ms/drive"},
               {"navigation", "s"},
               {"navigation", "of straight"},
               {"collisions", "1/drive"},
               {"our fault", "1/drive"},
               {"drives with none", "%"}}};
  for (const Row& row : rows) {
    const auto mean = [&row](double (*of)(const DynamicDrive&)) { return summarise(values_of(row, of)).mean; };
    const std::size_t arrived = values_of(row, kQuantities[0].of).size();
    table.add({row.preset, row.scenario, row.who, count_cell(row.drives.size()),
               count_cell(row.drives.size() - arrived), mean(kQuantities[0].of), mean(kQuantities[2].of),
               mean([](const DynamicDrive& drive) { return drive.navigation_s / drive.straight_s; }),
               mean(kQuantities[3].of), mean([](const DynamicDrive& d) { return static_cast<double>(d.at_fault); }),
               mean([](const DynamicDrive& drive) { return drive.collisions == 0 ? 100.0 : 0.0; })});
  }
  table.notes = {
      "7 and 5 obstacles to and fro at up to 2.5 m/s with a robot's acceleration, knowing nothing; bodies pass through "
      "each other; of the drives that arrived within a minute",
      "a path is planned for every frame; recalculated: frames that found an obstacle's centre within 90 mm "
      "of the path of the frame before",
      "fault by the crash rule; an obstacle that drives into the robot faster than it comes is to blame"};
  for (const char* name : kDynamicScenarios) table.notes.push_back(load_dynamic_scenario(name).rebuilt);
  return table;
}

/// How many drives had how many collisions, a bar per safety search of the last planner.
Plot histogram(const std::vector<Row>& rows, const std::string& preset, const std::string& scenario,
               const std::string& planner) {
  Plot plot{"collisions of a drive, " + scenario + ", preset " + preset, {"collisions"}, {"drives"}};
  std::size_t most = 0;
  for (const Row& row : rows) {
    if (row.preset != preset || row.scenario != scenario || row.system.planner != planner) continue;
    std::map<std::size_t, double> counts;
    for (const DynamicDrive& drive : row.drives) counts[drive.collisions] += 1.0;
    Series& series = plot.series.emplace_back(Series{row.who, {}, Series::Style::bars});
    for (const auto& [collisions, drives] : counts) {
      series.points.push_back({static_cast<double>(collisions), drives});
      most = std::max(most, collisions);
    }
  }
  plot.x.low = -0.5;
  plot.x.high = static_cast<double>(most) + 0.5;
  plot.y.low = 0.0;
  return plot;
}

}  // namespace

int run_dynamic(const DynamicOptions& options, const Run& run) {
  Report report(run);
  std::vector<Row> rows = rows_of(options);
  drive(rows, options, seed_of(options.seeds, run.seed));
  for (const std::string& preset : options.presets) {
    for (const Quantity& quantity : kQuantities) add_quantity(report, quantity, preset, rows);
    for (std::size_t i = 0; i < kDynamicScenarios.size(); ++i) {
      report.add("dynamic_histogram_" + preset + "_" + std::to_string(i + 1),
                 histogram(rows, preset, kDynamicScenarios.at(i), options.planners.back()));
    }
  }
  report.add("dynamic", summary_table(rows));
  Checker checker;
  for (const Row& row : rows) {
    for (const DynamicDrive& one : row.drives) check(checker, row.who, one.verdict);
  }
  return report.finish(checker);
}

}  // namespace regista::bench
