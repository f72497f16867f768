// Whole fleets planned on one shared graph, time per frame.
#include "modules/bench/scale_parts.h"

namespace regista::bench {
namespace {

constexpr double kGoal_ms = 16.0;   ///< one frame of a 60 Hz camera
constexpr double kNoLimit_s = 1e9;  ///< frames are planned whole

}  // namespace

void Scale::measure_fleets() {
  Contenders all = contenders(false);
  Table table{"scale: fleets among each other, one shared graph, time per frame",
              {{"planner"},
               {"robots"},
               {"frames"},
               {"success", "%"},
               {"time mean", "ms"},
               {"p50", "ms"},
               {"p99", "ms"},
               {"max", "ms"},
               {"mean per robot", "us"}}};
  Plot plot{
      "scale: a whole fleet planned on one shared graph", {"robots", "", true}, {"mean time per frame", "ms", true}};
  std::vector<Series> curves(all.size());
  Progress progress("scale, fleets", options_.robots.size());
  for (const std::size_t count : options_.robots) {
    const std::vector<ScaleSample> samples =
        rounds(all, options_.frames * count, [&](Contender& contender, ScaleSample& out, std::uint64_t round) {
          std::mt19937_64 random = random_of(ScalePart::fleets, count, round);
          const TeamScene scene = fleet(random, count, count);
          const Frame frame = plan_frame(contender, scene, kNoLimit_s, out);
          out.frame_ms.push_back(1e-3 * frame.total_us);
          out.each_us.insert(out.each_us.end(), frame.each_us.begin(), frame.each_us.end());
        });
    for (std::size_t k = 0; k < all.size(); ++k) {
      const Summary frame = summarise(samples[k].frame_ms);
      table.add({all[k].name, count_cell(count), count_cell(frame.count),
                 percent(samples[k].solved, samples[k].each_us.size()), frame.mean, frame.p50, frame.p99, frame.max,
                 1e3 * frame.mean / static_cast<double>(count)});
      curves[k].name = all[k].name;
      curves[k].points.push_back({static_cast<double>(count), frame.mean});
    }
    progress.advance();
  }
  plot.series = curves;
  plot.series.push_back(goal_line("16 ms", kGoal_ms, options_.robots));
  report_.add("scale_fleet", table);
  report_.add("scale_fleet", plot);
}

}  // namespace regista::bench
