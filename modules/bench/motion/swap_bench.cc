#include "modules/bench/motion/swap_bench.h"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "modules/bench/bench.h"
#include "modules/bench/motion/loop_recorder.h"
#include "modules/bench/motion/parallel.h"
#include "modules/bench/motion/scene_run.h"
#include "modules/bench/motion/verdict.h"
#include "modules/bench/tool.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

constexpr int kRecordEvery = 5;  // ticks: 20 pictures a second
constexpr std::size_t kStripPictures = 6;

struct Played {
  MotionScene scene;
  std::vector<SceneScore> runs;
  std::filesystem::path log;  ///< of the first run
};

std::vector<Played> chosen(const SwapOptions& options, const std::filesystem::path& out) {
  std::vector<Played> all;
  for (MotionScene& scene : swap_scenes()) {
    const bool wanted = options.scenes.empty() ||
                        std::any_of(options.scenes.begin(), options.scenes.end(), [&](const std::string& word) {
                          return scene.name.find(word) != std::string::npos;
                        });
    if (wanted) all.push_back({std::move(scene), std::vector<SceneScore>(options.runs), {}});
  }
  if (all.empty()) throw std::invalid_argument("no scene is named like that; without --scenes all are played");
  for (std::size_t i = 0; i < all.size(); ++i) all[i].log = out / fmt::format("swap_{}.lcmlog", i + 1);
  return all;
}

SceneScore play_recorded(const Played& played, const SwapOptions& options, std::uint64_t seed) {
  LoopRecorder recorder(played.log.string(), played.scene.field);
  int ticks = 0;
  SceneScore score = play_scene(played.scene, options.system, options.preset, seed, [&](const ClosedLoop& loop) {
    if (ticks++ % kRecordEvery == 0) recorder.record(loop);
  });
  recorder.close();
  return score;
}

void play(std::vector<Played>& all, const SwapOptions& options, std::uint64_t seed) {
  in_parallel("swap", all.size() * options.runs, options.jobs, [&](std::size_t i) {
    Played& played = all[i / options.runs];
    const std::size_t number = i % options.runs;
    const std::uint64_t run_seed = mixed(seed_of(options.seeds, seed), number);
    played.runs[number] = number == 0 ? play_recorded(played, options, run_seed)
                                      : play_scene(played.scene, options.system, options.preset, run_seed);
  });
}

std::vector<Cell> row_of(const Played& played) {
  std::vector<double> ratios, worst, waited_m, waiting_mps, ended_s;
  ContactCounts contacts;
  for (const SceneScore& run : played.runs) {
    ended_s.push_back(run.ended_s);
    contacts.own_yellow += run.contacts.own_yellow + run.contacts.own_blue;
    contacts.opponent += run.contacts.opponent;
    contacts.at_fault_yellow += run.contacts.at_fault_yellow;
    const std::size_t before = ratios.size();
    for (const Arrival& arrival : run.arrivals) {
      if (arrival.arrived_s) {
        ratios.push_back(*arrival.arrived_s / arrival.straight_s);
      } else {
        waited_m.push_back(arrival.waited_m);
        waiting_mps.push_back(arrival.waiting_mps);
      }
    }
    if (ratios.size() > before)
      worst.push_back(*std::max_element(ratios.begin() + static_cast<std::ptrdiff_t>(before), ratios.end()));
  }
  const double runs = static_cast<double>(played.runs.size());
  const auto per_run = [runs](std::int64_t count) { return static_cast<double>(count) / runs; };
  std::vector<Cell> row{played.scene.name,
                        count_cell(played.runs.size()),
                        count_cell(ratios.size() + waited_m.size()),
                        count_cell(waited_m.size()),
                        Cell(),
                        Cell(),
                        Cell(),
                        summarise(ended_s).mean,
                        per_run(contacts.own_yellow),
                        per_run(contacts.opponent),
                        per_run(contacts.at_fault_yellow),
                        Cell(),
                        Cell()};
  if (!ratios.empty()) {
    row[4] = summarise(ratios).mean;
    row[5] = summarise(worst).mean;
    row[6] = summarise(worst).max;
  }
  if (!waited_m.empty()) {
    row[11] = summarise(waited_m).mean;
    row[12] = summarise(waiting_mps).mean;
  }
  return row;
}

Table table_of(const std::vector<Played>& all, const SwapOptions& options) {
  Table table{"swap: robots in each other's way, preset " + options.preset,
              {{"scene"},
               {"runs"},
               {"robots"},
               {"not arrived"},
               {"time mean", "of straight"},
               {"worst of a run", "of straight"},
               {"worst of all", "of straight"},
               {"ended", "s"},
               {"own contacts", "1/run"},
               {"with opponents", "1/run"},
               {"our fault", "1/run"},
               {"waited", "m"},
               {"waiting speed", "m/s"}}};
  for (const Played& played : all) table.add(row_of(played));
  table.notes = {
      "time: until within 5 cm of the target, over the time-optimal straight drive from rest to rest; "
      "delay and lag are in the first alone",
      "worst of a run: the largest of its robots that arrived, mean over runs",
      "waited: mean distance to the target in the last 3 s of those not arrived; waiting speed: root mean "
      "square of theirs",
      "robots and arrivals are summed over runs; logs of the first runs: swap_<row>.lcmlog"};
  return table;
}

/// A strip of pictures of the swap of two teams, from its log. Says on stderr why there is none.
void draw_strip(const std::vector<Played>& all, const std::filesystem::path& out) {
  for (const Played& played : all) {
    if (played.scene.drivers.at(1) != SceneDriver::system) continue;
    const auto viewer = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "regista-viewer";
    std::string times;
    for (std::size_t i = 0; i < kStripPictures; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(kStripPictures - 1);
      times += fmt::format("{}{:.2f}", i > 0 ? "," : "", share * (played.runs.front().ended_s - 0.1));
    }
    const ToolResult result =
        run_tool(out, {viewer.string(), "--lcm-url", "file://" + std::filesystem::absolute(played.log).string(),
                       "--snapshot", "swap.png", "--size", "480x400", "--at", times});
    if (result.status != 0) std::fprintf(stderr, "regista: no picture of the swap: %s\n", result.output.c_str());
  }
}

}  // namespace

int run_swap(const SwapOptions& options, const Run& run) {
  Report report(run);
  std::vector<Played> all = chosen(options, run.out);
  play(all, options, run.seed);
  report.add("swap", table_of(all, options));
  if (options.pictures) draw_strip(all, run.out);
  Checker checker;
  for (const Played& played : all) {
    for (const SceneScore& one : played.runs) check(checker, played.scene.name, one.verdict);
  }
  return report.finish(checker);
}

}  // namespace regista::bench
