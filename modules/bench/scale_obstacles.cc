// Time per query against the number of obstacles, at constant density.
#include <fmt/core.h>

#include <optional>

#include "modules/bench/scale_parts.h"

namespace regista::bench {
namespace {

/// The slope is fitted from the obstacles of 11 against 11 upwards: below, most ways are straight.
constexpr std::size_t kFitFrom = 21;
constexpr std::size_t kShare = 2;  ///< every kShare-th robot asks and shares the set-up of the frame

/// From kFitFrom on; nothing for fewer than two sizes.
std::optional<double> exponent_of(const std::vector<Vec2>& points) {
  std::vector<Vec2> fitted;
  for (const Vec2& point : points) {
    if (point.x() >= static_cast<double>(kFitFrom)) fitted.push_back(point);
  }
  if (fitted.size() < 2) return std::nullopt;
  return fit_power_law(fitted).exponent;
}

}  // namespace

void Scale::measure_obstacles() {
  Contenders all = contenders(true);
  Table table{"scale: time per query against obstacles at the density of 11 against 11",
              {{"planner"},
               {"obstacles"},
               {"queries"},
               {"success", "%"},
               {"set-up", "us"},
               {"time mean", "us"},
               {"p50", "us"},
               {"p99", "us"},
               {"max", "us"}}};
  Plot plot{"scale: time per query at constant density", {"obstacles", "", true}, {"mean time per query", "µs", true}};
  std::vector<Series> curves(all.size());
  std::vector<std::vector<Vec2>> means(all.size()), medians(all.size());
  Progress progress("scale, obstacles", options_.obstacles.size());
  for (const std::size_t count : options_.obstacles) {
    const std::vector<ScaleSample> samples =
        rounds(all, options_.queries, [&](Contender& contender, ScaleSample& out, std::uint64_t round) {
          std::mt19937_64 random = random_of(ScalePart::obstacles, count, round);
          const TeamScene scene = fleet(random, count, std::max<std::size_t>(1, count / kShare));
          const Frame frame = plan_frame(contender, scene, share_s_ - out.spent_s, out);
          out.set_up_us.push_back(frame.set_up_us);
          const double part_us = frame.set_up_us / static_cast<double>(scene.requests.size());
          for (const double query_us : frame.each_us) out.each_us.push_back(part_us + query_us);
        });
    for (std::size_t k = 0; k < all.size(); ++k) {
      const Summary each = summarise(samples[k].each_us);
      table.add({all[k].name, count_cell(count), count_cell(each.count), percent(samples[k].solved, each.count),
                 summarise(samples[k].set_up_us).mean, each.mean, each.p50, each.p99, each.max});
      curves[k].points.push_back({static_cast<double>(count), each.mean});
      means[k].emplace_back(static_cast<double>(count), each.mean);
      medians[k].emplace_back(static_cast<double>(count), each.p50);
    }
    progress.advance();
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    curves[k].name = all[k].name;
    if (const std::optional<double> exponent = exponent_of(means[k])) {
      curves[k].name += fmt::format(" (N^{:.2f})", *exponent);
      table.notes.push_back(
          fmt::format("{}: from {} obstacles on the mean grows with N^{:.3f}, the median with N^{:.3f}", all[k].name,
                      kFitFrom, *exponent, exponent_of(medians[k]).value()));
    }
    plot.series.push_back(curves[k]);
  }
  table.notes.emplace_back("time of a query: its planning and its part of the frame's set-up, shared by N/2 robots");
  report_.add("scale_obstacles", table);
  report_.add("scale_obstacles", plot);
}

}  // namespace regista::bench
