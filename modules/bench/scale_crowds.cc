// Hundreds of discs on one field, many of them overlapping.
#include "modules/bench/scale_parts.h"

namespace regista::bench {
namespace {

constexpr double kGoal_us = 1000.0;  ///< p99

}  // namespace

void Scale::measure_crowds() {
  Contenders all = contenders(true);
  Table table{"scale: crowds of discs of 0.21 m on 12 x 9 m, many overlapping; each query from nothing",
              {{"planner"},
               {"discs"},
               {"queries"},
               {"success", "%"},
               {"unreachable", "%"},
               {"time mean", "us"},
               {"p50", "us"},
               {"p99", "us"},
               {"max", "us"}}};
  Plot plot{"scale: crowds on 12 x 9 m, p99 of a query", {"discs"}, {"p99 of time per query", "µs", true}};
  std::vector<Series> curves(all.size());
  Progress progress("scale, crowds", options_.crowds.size());
  for (const std::size_t count : options_.crowds) {
    const std::vector<ScaleSample> samples =
        rounds(all, options_.queries, [&](Contender& contender, ScaleSample& out, std::uint64_t round) {
          std::mt19937_64 random = random_of(ScalePart::crowds, count, round);
          const Scene scene = crowd(random, count);
          out.each_us.push_back(plan_once(contender, scene.world, scene.request).total_us);
          check(contender.name, scene.world, scene.request, contender.answer, out);
        });
    for (std::size_t k = 0; k < all.size(); ++k) {
      const Summary each = summarise(samples[k].each_us);
      table.add({all[k].name, count_cell(count), count_cell(each.count), percent(samples[k].solved, each.count),
                 percent(samples[k].unreachable, each.count), each.mean, each.p50, each.p99, each.max});
      curves[k].name = all[k].name;
      curves[k].points.push_back({static_cast<double>(count), each.p99});
    }
    progress.advance();
  }
  plot.series = curves;
  plot.series.push_back(goal_line("1 ms", kGoal_us, options_.crowds));
  table.notes = {"unreachable: proved to have no way; what is left of 100 % was not found"};
  report_.add("scale_crowd", table);
  report_.add("scale_crowd", plot);
}

}  // namespace regista::bench
