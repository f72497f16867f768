#include "modules/bench/motion/cost_bench.h"

#include "modules/bench/bench.h"
#include "modules/bench/motion/crowd_run.h"
#include "modules/bench/motion/parallel.h"
#include "modules/bench/motion/verdict.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

struct Row {
  std::string safety;  ///< "": the controller knows no choice
  Summary planning, control, tick;
  LoopVerdict verdict;
};

Row measured(const std::string& safety, const CrowdScore& score) {
  std::vector<double> planning, control, tick;
  for (const DriveTime& time : score.times) {
    planning.push_back(time.planning_us);
    control.push_back(time.control_us);
    tick.push_back(time.planning_us + time.control_us);
  }
  return {safety, summarise(std::move(planning)), summarise(std::move(control)), summarise(std::move(tick)),
          score.verdict};
}

Table table_of(const std::vector<Row>& rows, const CostOptions& options) {
  Table table{"cost: a tick of a team of 11 among 22, preset " + options.preset,
              {{"safety"},
               {"ticks"},
               {"planning mean", "us"},
               {"p50", "us"},
               {"p99", "us"},
               {"control mean", "us"},
               {"p50 of it", "us"},
               {"p99 of it", "us"},
               {"of these safety", "us"},
               {"both mean", "us"},
               {"both p99", "us"}}};
  for (const Row& row : rows) {
    std::vector<Cell> cells{row.safety.empty() ? "as it is" : row.safety,
                            count_cell(row.planning.count),
                            row.planning.mean,
                            row.planning.p50,
                            row.planning.p99,
                            row.control.mean,
                            row.control.p50,
                            row.control.p99,
                            Cell(),
                            row.tick.mean,
                            row.tick.p99};
    if (rows.front().safety == "none") cells[8] = row.control.mean - rows.front().control.mean;
    table.add(cells);
  }
  table.notes = {"single shots of the whole team, time of the core it runs on, 11 against 11 both driven like that",
                 "safety: mean of control beyond that without safety search; the games are not the same"};
  return table;
}

}  // namespace

int run_cost(const CostOptions& options, const Run& run) {
  const std::vector<std::string>& safety = options.safety;
  Report report(run);
  std::vector<Row> rows(safety.size());
  const std::uint64_t seed = seed_of(options.seeds, run.seed);
  in_parallel("cost", rows.size(), 1, [&](std::size_t i) {
    SystemChoice system = options.system;
    system.safety = safety[i];
    rows[i] = measured(safety[i], play_crowd({"A", options.preset, Opponents::system}, system, options.minutes, seed));
  });
  report.add("cost", table_of(rows, options));
  Checker checker;
  for (const Row& row : rows) check(checker, row.safety, row.verdict);
  return report.finish(checker);
}

}  // namespace regista::bench
