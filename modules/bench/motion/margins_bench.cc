#include "modules/bench/motion/margins_bench.h"

#include <fmt/core.h>

#include <cmath>

#include "modules/bench/bench.h"
#include "modules/bench/motion/contact_watch.h"
#include "modules/bench/motion/parallel.h"
#include "modules/bench/motion/target_sources.h"
#include "modules/bench/motion/verdict.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

constexpr std::size_t kRobots = 11;
constexpr double kPiece_min = 1.0;  // each from the grid, with a seed of its own
constexpr double kMetresPerMillimetre = 1e-3;

/// What the field does and the system does not know of.
struct ModelError {
  const char* name;
  const char* key;  ///< of SimParams; "" for none
  double value;
};

/// Over preset noisy: 30 ms delay, 30 ms lag.
constexpr std::array kErrors{ModelError{"as modelled", "", 0.0}, ModelError{"10 ms later", "radio.latency_s", 0.040},
                             ModelError{"lag 60 ms", "velocity_lag_s", 0.060},
                             ModelError{"5 % faster", "velocity_gain", 1.05},
                             ModelError{"5 % of commands lost", "radio.loss", 0.05}};

struct Row {
  ModelError error;
  double margin_mm = 0.0;
  ContactTally contacts = {};
  std::int64_t reached = 0;
  LoopVerdict verdict = {};
};

std::vector<Row> rows_of(const MarginsOptions& options) {
  std::vector<Row> rows;
  for (const ModelError& error : kErrors) {
    for (const double margin_mm : options.margins_mm) rows.push_back({error, margin_mm});
  }
  return rows;
}

constexpr const char* kMarginKey = "controller.safety.team_margin_m";

/// 5 × 4 m with next to no defence areas and no room beside.
FieldGeometry small_field() {
  FieldGeometry field;
  field.length_m = 5.0;
  field.width_m = 4.0;
  field.defence_depth_m = 0.01;
  field.defence_width_m = 0.01;
  field.goal_width_m = 0.5;
  return field;
}

std::vector<RobotPlacement> grid() {
  constexpr double kPitch_m = 1.0;
  constexpr std::size_t kRow = 4;
  std::vector<RobotPlacement> robots;
  for (std::size_t i = 0; i < kRobots; ++i) {
    const std::size_t row = i / kRow;
    const Vec2 place(static_cast<double>(i % kRow) - 1.5, static_cast<double>(row) - 1.0);
    robots.push_back({{Team::yellow, static_cast<std::uint16_t>(i)}, {kPitch_m * place, 0.0}});
  }
  return robots;
}

Row play(const Row& row, const SystemChoice& system, double minutes, std::uint64_t seed) {
  SystemChoice choice = system;
  choice.settings.push_back(fmt::format("{}={}", kMarginKey, row.margin_mm * kMetresPerMillimetre));
  const Config config = loop_config(choice, "noisy");
  LoopSetup setup = loop_setup(config, seed);
  if (*row.error.key != '\0') set_param(setup.sim.params, row.error.key, fmt::format("{}", row.error.value));
  setup.sim.field = small_field();
  setup.sim.robots = grid();
  RandomTargetsParams params;
  params.distance_min_m = 1.5;
  RandomTargets targets(Team::yellow, setup.sim.field, params, seed);
  setup.of(Team::yellow) = {std::make_unique<SystemDriver>(Team::yellow, system_params(config, Team::yellow)),
                            source_of(targets)};
  ContactWatch watch(Team::yellow, setup.sim.params.limits.radius_m);
  ClosedLoop loop(std::move(setup));
  loop.run_for(60.0 * minutes, [&] { watch.observe(loop.simulator(), loop.truth(), loop.dt_s()); });
  return {row.error, row.margin_mm, watch.tally(), targets.reached(), loop.verdict()};
}

void play_all(std::vector<Row>& rows, const MarginsOptions& options, std::uint64_t seed) {
  const auto pieces = static_cast<std::size_t>(std::ceil(options.minutes / kPiece_min));
  const double piece_min = options.minutes / static_cast<double>(pieces);
  std::vector<Row> played(rows.size() * pieces);
  in_parallel("margins", played.size(), options.jobs, [&](std::size_t i) {
    played[i] = play(rows[i / pieces], options.system, piece_min, mixed(seed, i % pieces));
  });
  for (std::size_t i = 0; i < played.size(); ++i) {
    rows[i / pieces].contacts += played[i].contacts;
    rows[i / pieces].reached += played[i].reached;
    rows[i / pieces].verdict += played[i].verdict;
  }
}

double contact_rate(const Row& row, double minutes) {
  return static_cast<double>(row.contacts.own) / (minutes * static_cast<double>(kRobots));
}

Table table_of(const std::vector<Row>& rows, double minutes) {
  Table table{"margins: 11 robots to random targets on 5 × 4 m that are not as modelled",
              {{"error"},
               {"margin", "mm"},
               {"minutes"},
               {"contacts"},
               {"contacts", "1/robot-min"},
               {"touching", "s/robot-min"},
               {"reached", "1/min"}}};
  for (const Row& row : rows) {
    table.add({row.error.name, row.margin_mm, minutes, row.contacts.own, contact_rate(row, minutes),
               row.contacts.own_touching_s / (minutes * static_cast<double>(kRobots)),
               static_cast<double>(row.reached) / minutes});
  }
  table.notes = {"preset noisy: 30 ms delay, 30 ms lag, vision 1.3 mm; the system knows these and not the error",
                 std::string("margin: ") + kMarginKey};
  return table;
}

Plot plot_of(const std::vector<Row>& rows, double minutes) {
  Plot plot{"contacts inside the team against its margin", {"margin", "mm"}, {"contacts", "1/robot-min"}};
  for (const Row& row : rows) {
    if (plot.series.empty() || plot.series.back().name != row.error.name) plot.series.push_back({row.error.name, {}});
    plot.series.back().points.push_back({row.margin_mm, contact_rate(row, minutes)});
  }
  plot.y.low = 0.0;
  return plot;
}

}  // namespace

int run_margins(const MarginsOptions& options, const Run& run) {
  Report report(run);
  std::vector<Row> rows = rows_of(options);
  play_all(rows, options, seed_of(options.seeds, run.seed));
  report.add("margins", table_of(rows, options.minutes));
  report.add("margins", plot_of(rows, options.minutes));
  Checker checker;
  for (const Row& row : rows) check(checker, row.error.name, row.verdict);
  return report.finish(checker);
}

}  // namespace regista::bench
