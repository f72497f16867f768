// Figures 22 and 23: how many drives of the dynamic test had how many collisions.
#include <numeric>

#include "modules/bench/paper/dvg_drives.h"
#include "modules/bench/paper/dvg_dynamic.h"
#include "modules/bench/paper/dvg_tables.h"

namespace regista::bench {
namespace {

/// How many of the drives had low … high collisions.
std::size_t drives_with(const DriveLog& log, std::size_t low, std::size_t high) {
  return static_cast<std::size_t>(std::count_if(log.collisions.begin(), log.collisions.end(), [&](double collisions) {
    return static_cast<double>(low) <= collisions && collisions <= static_cast<double>(high);
  }));
}

double share_percent(const DriveLog& log, std::size_t drives) {
  return log.collisions.empty() ? 0.0
                                : 100.0 * static_cast<double>(drives) / static_cast<double>(log.collisions.size());
}

std::size_t most_collisions(const std::vector<DriveLog>& logs) {
  double most = 0.0;
  for (const DriveLog& log : logs)
    most = std::accumulate(log.collisions.begin(), log.collisions.end(), most,
                           [](double a, double b) { return std::max(a, b); });
  return static_cast<std::size_t>(most);
}

Cell printed(const Published& published, const std::string& what, const std::string& who) {
  for (const PublishedRow& row : published.rows) {
    if (row.what == what && row.who == who) return row.mean;
  }
  return {};
}

/// The numbers that the text gives of a histogram, and the histogram.
Table table_of(const std::string& title, const Published& published, const std::vector<DriveLog>& logs) {
  Table table{title, {{"planner"}, {"row"}, {"drives"}}};
  for (const char* what : {"all collisions", "drives with none", "drives with 1 or 2", "drives with 5"}) {
    table.columns.push_back({what, published.units.at(what)});
  }
  const std::size_t most = most_collisions(logs);
  for (std::size_t n = 0; n <= most; ++n) table.columns.push_back({"with " + std::to_string(n)});
  for (const DriveLog& log : logs) {
    std::vector<Cell> row{log.who, "published", count_cell(published.samples)};
    for (std::size_t i = 3; i < 7; ++i) row.push_back(printed(published, table.columns[i].name, log.who));
    const bool is_printed = std::any_of(row.begin() + 3, row.end(), [](const Cell& cell) { return cell != Cell(); });
    row.resize(table.columns.size());
    if (is_printed) table.add(row);
    const double all = std::accumulate(log.collisions.begin(), log.collisions.end(), 0.0);
    row = {log.who,
           "measured",
           count_cell(log.collisions.size()),
           all,
           share_percent(log, drives_with(log, 0, 0)),
           share_percent(log, drives_with(log, 1, 2)),
           count_cell(drives_with(log, 5, 5))};
    for (std::size_t n = 0; n <= most; ++n) row.push_back(count_cell(drives_with(log, n, n)));
    table.add(row);
  }
  table.notes = notes_of(logs);
  table.notes.emplace_back("the figure is lost; published is what its text says (\"around\", \"a little less\")");
  return table;
}

Plot plot_of(const std::string& title, const std::vector<DriveLog>& logs) {
  const std::size_t most = most_collisions(logs);
  Plot plot{title, {"collisions of a drive"}, {"drives"}};
  for (const DriveLog& log : logs) {
    Series& series = plot.series.emplace_back(Series{log.who, {}, Series::Style::bars});
    for (std::size_t n = 0; n <= most; ++n) {
      series.points.push_back({static_cast<double>(n), static_cast<double>(drives_with(log, n, n))});
    }
  }
  plot.x.low = -0.5;
  plot.x.high = static_cast<double>(most) + 0.5;
  plot.y.low = 0.0;
  return plot;
}

}  // namespace

int run_dvg_figures22_23(const PaperOptions& options, const Run& run) {
  Report report(run);
  Checker checker;
  for (std::size_t i = 0; i < kDynamicScenarios.size(); ++i) {
    const std::string figure = i == 0 ? "figure22" : "figure23";
    const Published published = published_of(figure);
    const std::size_t drives = options.samples > 0 ? options.samples : published.samples;
    const std::vector<DriveLog> logs = drive_all(i, drives, run.seed, checker);
    const std::string title = "dvg-" + figure + ": collisions, " + load_dynamic_scenario(kDynamicScenarios.at(i)).title;
    report.add("dvg_" + figure, table_of(title, published, logs));
    report.add("dvg_" + figure, plot_of(title, logs));
  }
  return report.finish(checker);
}

}  // namespace regista::bench
