#include "modules/bench/motion/motion_bench.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "modules/bench/bench.h"
#include "modules/bench/motion/braking_time.h"
#include "modules/bench/motion/free_move.h"
#include "modules/bench/motion/minimum_time.h"
#include "modules/bench/motion/parallel.h"
#include "modules/bench/motion/standing_drive.h"
#include "modules/bench/motion/verdict.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

constexpr double kFarthest_m = 3.0;
constexpr double kFastest_mps = 3.0;
constexpr double kAcceleration_mps2 = 3.0;
constexpr double kBraking_mps2 = 4.0;

/// Free moves under limits, compared with the optimum under a disc.
struct FreeRow {
  std::string limits;
  double braking_mps2 = 0.0;  ///< of the robot; it speeds up with kAcceleration_mps2
  std::string bound;
  double disc_mps2 = 0.0;  ///< 0: the limits model itself
  std::vector<double> ratios = {};
  std::size_t lost = 0;
  std::size_t unknown = 0;  ///< moves whose least time was not found
};

struct StandingRow {
  std::string preset;
  std::vector<double> ratios = {};
  std::size_t lost = 0;
  std::int64_t contacts = 0;
  LoopVerdict verdict = {};
};

Vec2 in_disc(std::mt19937_64& random, double radius) {
  const double distance = radius * std::sqrt(uniform(random));
  return regista::rotated({distance, 0.0}, uniform(random, -std::numbers::pi, std::numbers::pi));
}

double share_of(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
}

/// The optimum that a row compares with; none where it was not found.
std::optional<double> least_s(const FreeRow& row, const FreeState& from) {
  if (row.disc_mps2 == 0.0) {
    return braking_time(from.position_m, from.velocity_mps, kAcceleration_mps2, row.braking_mps2);
  }
  return minimum_time(from.position_m, from.velocity_mps, row.disc_mps2).duration_s;
}

/// One move's times over the optima of all rows: NaN where it did not arrive, none where no optimum is known.
std::vector<std::optional<double>> ratios_of(const std::vector<FreeRow>& rows, const SystemChoice& system,
                                             std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const FreeState from{in_disc(random, kFarthest_m), in_disc(random, kFastest_mps)};
  std::vector<std::optional<double>> ratios;
  for (const FreeRow& row : rows) {
    const FreeMove move = drive_freely(from, free_params(system, kAcceleration_mps2, row.braking_mps2));
    // The last centimetre counts with its own least time, so that no tolerance flatters.
    const double rest_s = minimum_time(move.then.position_m, move.then.velocity_mps, row.braking_mps2).duration_s;
    const std::optional<double> least = least_s(row, from);
    ratios.push_back(least ? std::optional(move.arrived_s ? (*move.arrived_s + rest_s) / *least : std::nan(""))
                           : std::nullopt);
  }
  return ratios;
}

void play_free(std::vector<FreeRow>& rows, const MotionOptions& options, std::uint64_t seed) {
  std::vector<std::vector<std::optional<double>>> all(options.moves);
  in_parallel("motion, free", all.size(), options.jobs,
              [&](std::size_t i) { all[i] = ratios_of(rows, options.system, mixed(seed, i)); });
  for (const auto& ratios : all) {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (!ratios[k]) {
        ++rows[k].unknown;
      } else if (std::isnan(*ratios[k])) {
        ++rows[k].lost;
      } else {
        rows[k].ratios.push_back(*ratios[k]);
      }
    }
  }
}

void play_standing(std::vector<StandingRow>& rows, const MotionOptions& options, std::uint64_t seed) {
  std::vector<StandingDrive> all(rows.size() * options.drives);
  in_parallel("motion, among standing robots", all.size(), options.jobs, [&](std::size_t i) {
    all[i] = drive_among_standing(options.system, rows[i / options.drives].preset, mixed(seed, i % options.drives));
  });
  for (std::size_t i = 0; i < all.size(); ++i) {
    StandingRow& row = rows[i / options.drives];
    row.contacts += all[i].contacts;
    row.verdict += all[i].verdict;
    if (all[i].arrived_s) {
      row.ratios.push_back(*all[i].arrived_s / all[i].ideal_s);
    } else {
      ++row.lost;
    }
  }
}

Table free_table(const std::vector<FreeRow>& rows) {
  Table table{"motion: free moves from random states to rest, over the least time",
              {{"limits"},
               {"least time of"},
               {"moves"},
               {"not arrived"},
               {"least unknown"},
               {"mean"},
               {"p50"},
               {"p95"},
               {"max"}}};
  for (const FreeRow& row : rows) {
    const Summary summary = summarise(row.ratios, row.lost);
    table.add({row.limits, row.bound, count_cell(summary.count), count_cell(row.lost), count_cell(row.unknown),
               summary.mean, summary.p50, share_of(row.ratios, 0.95), summary.max});
  }
  table.notes = {
      "from up to 3 m and 3 m/s; exact vision at 100 Hz, no delay, no limit of speed; the last centimetre counts with "
      "its own least time",
      "the limits model (half a disc ahead, half an ellipse behind) lies between the discs of 3 and of 4 m/s², and so "
      "do the least times; its own is found by continuation, but not near reversals on a line"};
  return table;
}

Table standing_table(const std::vector<StandingRow>& rows) {
  Table table{"motion: one robot among 21 that stand, over the ideal time along the path",
              {{"preset"}, {"drives"}, {"not arrived"}, {"mean"}, {"p50"}, {"p95"}, {"max"}, {"contacts"}}};
  for (const StandingRow& row : rows) {
    const Summary summary = summarise(row.ratios, row.lost);
    table.add({row.preset, count_cell(summary.count), count_cell(row.lost), summary.mean, summary.p50,
               share_of(row.ratios, 0.95), summary.max, row.contacts});
  }
  table.notes = {"ideal: the first plan's length as a straight line from rest to rest, 3 m/s, 3 m/s² up, 4 m/s² down",
                 "measured from the first plan until within 1 cm and slower than 0.3 m/s; delay and lag are in it"};
  return table;
}

/// Which share of the moves is at most so far from the least time.
Plot shares_plot(const std::vector<FreeRow>& free, const std::vector<StandingRow>& standing) {
  Plot plot{"time over the least (free) or ideal (among standing robots)", {"share of the moves", "%"}, {"ratio"}};
  const auto add = [&plot](const std::string& name, std::vector<double> ratios) {
    Series series{name, {}, Series::Style::line};
    std::sort(ratios.begin(), ratios.end());
    const double count = static_cast<double>(ratios.size());
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      series.points.push_back({100.0 * (static_cast<double>(i) + 0.5) / count, ratios[i]});
    }
    plot.series.push_back(std::move(series));
  };
  for (const FreeRow& row : free) add("free, " + row.limits + ", " + row.bound, row.ratios);
  for (const StandingRow& row : standing) add("standing, " + row.preset, row.ratios);
  return plot;
}

}  // namespace

int run_motion(const MotionOptions& options, const Run& run) {
  Report report(run);
  std::vector<FreeRow> free{{"3 m/s² all around", kAcceleration_mps2, "disc of 3 m/s², exact", kAcceleration_mps2},
                            {"3 up, 4 down", kBraking_mps2, "limits model", 0.0},
                            {"3 up, 4 down", kBraking_mps2, "disc of 3 m/s²", kAcceleration_mps2},
                            {"3 up, 4 down", kBraking_mps2, "disc of 4 m/s²", kBraking_mps2}};
  std::vector<StandingRow> standing;
  for (const std::string& preset : options.presets) standing.push_back({preset});
  const std::uint64_t seed = seed_of(options.seeds, run.seed);
  play_free(free, options, seed);
  play_standing(standing, options, mixed(seed, 1));
  report.add("motion_free", free_table(free));
  report.add("motion_standing", standing_table(standing));
  report.add("motion", shares_plot(free, standing));
  Checker checker;
  for (const StandingRow& row : standing) check(checker, row.preset, row.verdict);
  return report.finish(checker);
}

}  // namespace regista::bench
