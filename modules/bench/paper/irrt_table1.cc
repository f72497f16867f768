#include "modules/bench/paper/irrt_table1.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "modules/bench/bench.h"
#include "modules/bench/paper/sampling_data.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

struct Row {
  std::string label;
  Contender contender;
  std::optional<double> published_time, published_length;  ///< without unit
  std::vector<double> time_us, length_m;
  std::size_t failures = 0;
  std::vector<Vec2> first_path = {};
};

std::vector<Row> rows_of(const DataTable& data) {
  std::vector<Row> rows;
  for (const DataTable& row : data.tables("row")) {
    rows.push_back({row.text("label"), contender_of(row), {}, {}, {}, {}});
    if (!row.has("published_time")) continue;
    rows.back().published_time = row.number("published_time");
    rows.back().published_length = row.number("published_length");
  }
  return rows;
}

/// Another order each time: next to its like, whose code and tree are warm, a planner is a third faster.
std::vector<std::size_t> shuffled(std::size_t count, std::mt19937_64& random) {
  std::vector<std::size_t> order = rotated(count, 0);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

void measure(std::vector<Row>& rows, Scene scene, std::size_t runs, double budget_us, const Run& run,
             Checker& checker) {
  Progress progress("irrt-table1", runs);
  for (std::size_t i = 0; i < runs; ++i, progress.advance()) {
    std::mt19937_64 random(mixed(run.seed, i));
    for (const std::size_t k : shuffled(rows.size(), random)) {
      Row& row = rows[k];
      scene.request.seed = random();
      const Shot shot = plan_once(row.contender, scene.world, scene.request, budget_us);
      row.time_us.push_back(shot.total_us);
      const Plan& plan = row.contender.answer;
      if (!checker.check(row.contender.name, scene.world, scene.request, plan) || plan.status != PlanStatus::ok) {
        ++row.failures;
        continue;
      }
      row.length_m.push_back(plan.length_m);
      if (row.first_path.empty()) row.first_path = plan.path;
    }
  }
}

/// Least of the published planners' values; what is beside them does not count.
template <class Value>
double best(const std::vector<Row>& rows, Value value) {
  double least = std::numeric_limits<double>::infinity();
  for (const Row& row : rows) {
    if (row.published_time) least = std::min(least, value(row));
  }
  return least;
}

double mean_length_m(const Row& row) {
  return row.length_m.empty() ? std::numeric_limits<double>::infinity() : summarise(row.length_m).mean;
}

double median_us(const Row& row) { return summarise(row.time_us).p50; }

Table table_of(const std::vector<Row>& rows) {
  Table table{
      "Iterative RRT-Smooth, table I: one map, mean of the runs; ratios are to the best published planner of the "
      "column",
      {{"method"},
       {"planner"},
       {"published time"},
       {"/ best", "x", 3},
       {"measured time", "us"},
       {"/ best", "x", 3},
       {"p50", "us"},
       {"/ best", "x", 3},
       {"published length"},
       {"/ best", "x", 4},
       {"measured length", "m"},
       {"sigma", "m", 3},
       {"/ best", "x", 4},
       {"found", "%"}}};
  const double best_time = best(rows, [](const Row& row) { return *row.published_time; });
  const double best_length = best(rows, [](const Row& row) { return *row.published_length; });
  const double best_us = best(rows, [](const Row& row) { return summarise(row.time_us).mean; });
  const double best_p50_us = best(rows, median_us);
  const double best_m = best(rows, mean_length_m);
  const auto cell = [](const std::optional<double>& value, double unit) {
    return value ? Cell{*value / unit} : Cell{};
  };
  for (const Row& row : rows) {
    const Summary time = summarise(row.time_us);
    const Summary length = summarise(row.length_m, row.failures);
    const bool any = length.count > 0;
    table.add({row.label, row.contender.name, cell(row.published_time, 1.0), cell(row.published_time, best_time),
               time.mean, time.mean / best_us, time.p50, time.p50 / best_p50_us, cell(row.published_length, 1.0),
               cell(row.published_length, best_length), any ? Cell{length.mean} : Cell{},
               any ? Cell{length.sigma} : Cell{}, any ? Cell{length.mean / best_m} : Cell{}, 100.0 * length.success()});
  }
  table.notes = {"means as the paper's; medians beside them, as another program that takes the processor shifts a mean",
                 "the paper prints no units; with epsilon 50 read as 0.5 m its lengths are centimetres",
                 "its map is lost: rebuilt from the text, see the data file"};
  return table;
}

/// The outlines of what a robot's centre keeps out of, as dots.
Series rings_of(const std::vector<Obstacle>& obstacles) {
  constexpr int kDots = 24;
  Series series{"kept free around robots", {}, Series::Style::points};
  for (const Obstacle& obstacle : obstacles) {
    for (int i = 0; i < kDots; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kDots;
      const Vec2 point = obstacle.a + obstacle.radius_m * Vec2(std::cos(angle), std::sin(angle));
      series.points.push_back({point.x(), point.y()});
    }
  }
  return series;
}

/// As the paper's figure 9: the paths of one run on the map.
Plot map_of(const std::vector<Row>& rows, const Scene& scene) {
  constexpr double kAspect = 1.85;  // of the plot's area, so that circles are circles
  const Vec2& half = scene.world.bounds.half_extent_m;
  Plot plot{"Iterative RRT-Smooth, figure 9: the paths of the first run",
            {"x", "m", false, -kAspect * half.y(), kAspect * half.y()},
            {"y", "m", false, -half.y(), half.y()}};
  for (const Row& row : rows) {
    Series series{row.contender.name, {}, Series::Style::line};
    for (const Vec2& point : row.first_path) series.points.push_back({point.x(), point.y()});
    plot.series.push_back(std::move(series));
  }
  plot.series.push_back(rings_of(scene.world.obstacles));
  return plot;
}

/// For every method a line from the published to the measured point, both over the best.
Plot ratios_of(const std::vector<Row>& rows) {
  const double best_time = best(rows, [](const Row& row) { return *row.published_time; });
  const double best_length = best(rows, [](const Row& row) { return *row.published_length; });
  const double best_us = best(rows, median_us);
  const double best_m = best(rows, mean_length_m);
  Plot plot{"Iterative RRT-Smooth, table I: from the published to the measured point, over the best of the six",
            {"time / best (published: mean, measured: median)", "", true},
            {"length / best"}};
  Series published{"published", {}, Series::Style::marks};
  for (const Row& row : rows) {
    Series series{row.contender.name, {}};
    if (row.published_time) {
      series.points.push_back({*row.published_time / best_time, *row.published_length / best_length});
      published.points.push_back(series.points.front());
    }
    if (!row.length_m.empty()) {
      series.points.push_back({median_us(row) / best_us, mean_length_m(row) / best_m});
    }
    plot.series.push_back(std::move(series));
  }
  plot.series.push_back(std::move(published));
  return plot;
}

}  // namespace

Scene irrt_scene() {
  const DataTable data = DataTable(kIrrtFile).table("scenario");
  Scene scene;
  scene.world.bounds.half_extent_m = Vec2(data.number("length_m"), data.number("width_m")) / 2;
  const double radius_m = data.number("robot_radius_m") + data.number("agent_radius_m") + data.number("threshold_m");
  for (const Vec2& robot : data.points("robots_m")) scene.world.obstacles.push_back(disc(robot, radius_m));
  scene.request.start = data.point("start_m");
  scene.request.goal = data.point("goal_m");
  scene.request.budget.iterations = static_cast<std::int64_t>(data.count("iterations"));
  return scene;
}

int run_irrt_table1(const PaperOptions& options, const Run& run) {
  const DataTable data(kIrrtFile);
  std::vector<Row> rows = rows_of(data);
  const Scene scene = irrt_scene();
  Report report(run);
  Checker checker;
  measure(rows, scene, options.samples > 0 ? options.samples : data.count("runs"), options.budget_us, run, checker);
  report.add("irrt-table1", table_of(rows));
  report.add("irrt-table1", ratios_of(rows));
  report.add("irrt-figure9", map_of(rows, scene));
  return report.finish(checker);
}

}  // namespace regista::bench
