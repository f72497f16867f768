#include "modules/bench/motion/crowd_bench.h"

#include <cmath>

#include "modules/bench/bench.h"
#include "modules/bench/motion/crowd_report.h"
#include "modules/bench/motion/parallel.h"
#include "modules/bench/motion/verdict.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

/// A game's minutes are played in pieces, each from the formation and with seeds of its own: for the threads.
constexpr double kPiece_min = 2.0;

std::vector<CrowdRow> rows_of(const CrowdOptions& options) {
  std::vector<CrowdRow> rows;
  for (const std::string& division : options.fields) {
    for (const std::string& preset : options.presets) {
      for (const std::string& opponents : options.opponents) {
        rows.push_back({{division, preset, opponents_of(opponents)}, {}});
      }
      if (options.pass_through) rows.push_back({{division, preset, Opponents::none}, {}});
    }
  }
  return rows;
}

/// All rows see the same seeds, so that they compare.
void play(std::vector<CrowdRow>& rows, const CrowdOptions& options, std::uint64_t seed) {
  const auto pieces = static_cast<std::size_t>(std::ceil(options.minutes / kPiece_min));
  const double piece_min = options.minutes / static_cast<double>(pieces);
  std::vector<CrowdScore> scores(rows.size() * pieces);
  in_parallel("crowd", scores.size(), options.jobs, [&](std::size_t i) {
    const std::uint64_t piece_seed = mixed(seed_of(options.seeds, seed), i % pieces);
    scores[i] = play_crowd(rows[i / pieces].game, options.system, piece_min, piece_seed);
  });
  for (std::size_t i = 0; i < scores.size(); ++i) rows[i / pieces].score += scores[i];
}

}  // namespace

int run_crowd(const CrowdOptions& options, const Run& run) {
  std::vector<CrowdRow> rows = rows_of(options);
  Report report(run);
  play(rows, options, run.seed);
  Checker checker;
  for (const CrowdRow& row : rows) check(checker, name(row.game.opponents), row.score.verdict);
  report.add("crowd", crowd_scores(rows, options));
  const Table cost = crowd_costs(rows);
  if (!cost.rows.empty()) report.add("crowd_cost", cost);
  add_crowd_plots(report, rows, options);
  return report.finish(checker);
}

}  // namespace regista::bench
