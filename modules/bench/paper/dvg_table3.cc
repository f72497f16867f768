// Table 3: how large groups of robots are. The paper's four match logs are not published; instead four simulated runs
// of two teams whose robots go to random places (our main job), two per division as the paper has both.
#include <fmt/core.h>

#include <array>

#include "modules/bench/paper/dvg_groups.h"
#include "modules/bench/paper/dvg_static.h"
#include "modules/bench/paper/dvg_tables.h"
#include "modules/lockstep/whole_loop.h"

namespace regista::bench {
namespace {

struct Crowd {
  const char* division;
  int robots_per_team;  ///< as in the year of the paper: eight in division A, six in B
};
constexpr std::array kCrowds{Crowd{"A", 8}, Crowd{"A", 8}, Crowd{"B", 6}, Crowd{"B", 6}};
constexpr std::array kGroupDistances_m{0.5, 1.5};
constexpr double kEvery_s = 0.1;     // between two looks
constexpr double kSampled_s = 0.25;  // of simulated time per sample: 200 samples are 50 s

std::vector<Sampled> watch(std::size_t number, double duration_s, std::uint64_t seed) {
  const Crowd& crowd = kCrowds.at(number);
  const Config config = Config::load("", {fmt::format("scenario.field.division={}", crowd.division),
                                          fmt::format("scenario.robots_per_team={}", crowd.robots_per_team),
                                          fmt::format("scenario.seed={}", seed % 1'000'000 + number),
                                          "scenario.target_distance_min_m=3", "scenario.sim_preset=noisy"});
  LockStep loop{Time{}};
  const WholeLoop modules = add_whole_loop(loop, config, [] { return std::int64_t{0}; });
  std::vector<Sampled> sampled;
  sampled.reserve(std::size(kGroupDistances_m));
  for (const double distance_m : kGroupDistances_m) {
    sampled.push_back({fmt::format("d_group {} m", distance_m), "group", fmt::format("crowd {}", number + 1), {}});
  }
  while (loop.now() < Time{} + from_seconds(duration_s)) {
    loop.run_until(loop.now() + from_seconds(kEvery_s));
    std::vector<Vec2> robots;
    for (const auto& robot : modules.sim->simulator().truth().robots) robots.push_back(robot.pose.position_m);
    for (std::size_t i = 0; i < sampled.size(); ++i) {
      for (const std::size_t size : group_sizes(robots, kGroupDistances_m.at(i))) {
        sampled[i].values.push_back(static_cast<double>(size));
      }
    }
  }
  return sampled;
}

}  // namespace

int run_dvg_table3(const PaperOptions& options, const Run& run) {
  Report report(run);
  const Published published = published_of("table3");
  const std::size_t samples = options.samples > 0 ? options.samples : published.samples;
  std::vector<Sampled> sampled;
  Progress progress("dvg-table3", kCrowds.size());
  for (std::size_t i = 0; i < kCrowds.size(); ++i, progress.advance()) {
    for (Sampled& sample : watch(i, kSampled_s * static_cast<double>(samples), run.seed))
      sampled.push_back(std::move(sample));
  }
  Table table = comparison("dvg-table3: robots in a group", published, sampled);
  table.notes = {
      "not the same robots: published are four match logs that are not at hand; measured are simulated crowds, robots "
      "going to random places: 1 and 2 eight against eight on division A's field, 3 and 4 six against six on B's",
      fmt::format("{} s each, looked at every {} s; a sample is a group, a robot alone is a group of one",
                  kSampled_s * static_cast<double>(samples), kEvery_s)};
  report.add("dvg_table3", table);
  sampled.reserve(std::size(kGroupDistances_m));
  for (const double distance_m : kGroupDistances_m) {
    const std::string where = fmt::format("d_group {} m", distance_m);
    report.add(distance_m < 1.0 ? "dvg_table3_near" : "dvg_table3_far",
               boxes("dvg-table3: robots in a group, " + where, where, "group", published, sampled));
  }
  return report.finish(Checker());
}

}  // namespace regista::bench
