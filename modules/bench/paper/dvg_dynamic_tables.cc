// Tables 8 to 11: the dynamic test, 200 drives per scenario and planner.
#include "modules/bench/paper/dvg_drives.h"
#include "modules/bench/paper/dvg_dynamic.h"
#include "modules/bench/paper/dvg_tables.h"

namespace regista::bench {
namespace {

std::vector<DriveLog> both_scenarios(const PaperOptions& options, const Run& run, Checker& checker) {
  const std::size_t drives = options.samples > 0 ? options.samples : published_of("table8").samples;
  std::vector<DriveLog> logs = drive_all(0, drives, run.seed, checker);
  for (DriveLog& log : drive_all(1, drives, run.seed, checker)) logs.push_back(std::move(log));
  return logs;
}

int run_table(const std::string& number, const std::string& title, const std::string& what,
              std::vector<double> DriveLog::*values, const PaperOptions& options, const Run& run) {
  Report report(run);
  Checker checker;
  const Published published = published_of("table" + number);
  const std::vector<DriveLog> logs = both_scenarios(options, run, checker);
  std::vector<Sampled> sampled;
  sampled.reserve(logs.size());
  for (const DriveLog& log : logs) sampled.push_back({log.where, what, log.who, log.*values, log.lost});
  Table table = comparison("dvg-table" + number + ": " + title, published, sampled);
  table.notes = notes_of(logs);
  const std::string stem = "dvg_table" + number;
  report.add(stem, table);
  for (std::size_t i = 0; i < kDynamicScenarios.size(); ++i) {
    const std::string where = kDynamicScenarios.at(i);
    const std::string heading = "dvg-table" + number + ": " + load_dynamic_scenario(where).title;
    const Plot plot = boxes(heading, where, what, published, sampled);
    if (!plot.boxes.empty()) report.add(stem + "_" + std::to_string(i + 1), plot);
  }
  return report.finish(checker);
}

}  // namespace

int run_dvg_table8(const PaperOptions& options, const Run& run) {
  return run_table("8", "planning time of all paths of a drive", "planning", &DriveLog::planning_ms, options, run);
}

int run_dvg_table9(const PaperOptions& options, const Run& run) {
  return run_table("9", "recalculated paths", "recalculated", &DriveLog::recalculated, options, run);
}

int run_dvg_table10(const PaperOptions& options, const Run& run) {
  return run_table("10", "time from start to goal", "navigation", &DriveLog::navigation_s, options, run);
}

int run_dvg_table11(const PaperOptions& options, const Run& run) {
  return run_table("11", "collisions of a drive", "collisions", &DriveLog::collisions, options, run);
}

}  // namespace regista::bench
