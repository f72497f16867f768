#include "modules/bench/team_bench.h"

#include "modules/bench/bench.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

constexpr std::uint64_t kWarmUpFrames = 20;

struct Sides {
  Contender shared, separate;
  std::vector<Plan> shared_answers, separate_answers;
  std::vector<double> shared_us, separate_us;
};

/// One field and one graph, then all robots.
double plan_shared(Sides& sides, const TeamScene& scene) {
  const std::vector<Obstacle> obstacles = scene.world.obstacles;  // as if just made
  sides.shared_answers.resize(scene.requests.size());
  sides.shared.graph.clear();
  const SingleShot whole;
  sides.shared.graph.reset(scene.world.bounds, obstacles);
  for (std::size_t i = 0; i < scene.requests.size(); ++i) {
    sides.shared.planner->plan(sides.shared.graph, scene.requests[i], sides.shared_answers[i]);
  }
  return whole.us();
}

/// Field and graph anew for every robot.
double plan_separately(Sides& sides, const TeamScene& scene) {
  const std::vector<Obstacle> obstacles = scene.world.obstacles;
  sides.separate_answers.resize(scene.requests.size());
  const SingleShot whole;
  for (std::size_t i = 0; i < scene.requests.size(); ++i) {
    sides.separate.graph.clear();
    sides.separate.graph.reset(scene.world.bounds, obstacles);
    sides.separate.planner->plan(sides.separate.graph, scene.requests[i], sides.separate_answers[i]);
  }
  return whole.us();
}

void check(const Sides& sides, const TeamScene& scene, Checker& checker) {
  for (std::size_t i = 0; i < scene.requests.size(); ++i) {
    checker.check(sides.shared.name, scene.world, scene.requests[i], sides.shared_answers[i]);
    if (sides.shared_answers[i] == sides.separate_answers[i]) continue;
    checker.add_fault(sides.shared.name, "robot " + std::to_string(i) + " gets another answer on the shared graph");
  }
}

Table table_of(const std::vector<Sides>& all, const Checker& checker) {
  Table table{"team: 11 robots on one shared graph, against 11 separate queries; building included in both",
              {{"planner"},
               {"frames"},
               {"shared mean", "us"},
               {"p50", "us"},
               {"p99", "us"},
               {"separate mean", "us"},
               {"p50 of these", "us"},
               {"p99 of these", "us"},
               {"ratio of means", "%"},
               {"ratio of medians", "%"},
               {"faults"}}};
  for (const Sides& sides : all) {
    const Summary shared = summarise(sides.shared_us);
    const Summary separate = summarise(sides.separate_us);
    table.add({sides.shared.name, count_cell(shared.count), shared.mean, shared.p50, shared.p99, separate.mean,
               separate.p50, separate.p99, 100.0 * shared.mean / separate.mean, 100.0 * shared.p50 / separate.p50,
               count_cell(checker.faults(sides.shared.name))});
  }
  table.notes = {"time: a whole frame of 11 robots, single shots, planners and both ways interleaved"};
  return table;
}

std::vector<Sides> make_sides(std::vector<std::string> names) {
  if (names.empty()) {
    for (const char* name : {"tangent", "visibility_sampling"}) {
      if (is_registered(name)) names.emplace_back(name);
    }
  }
  Contenders shared = make_contenders(names);
  Contenders separate = make_contenders(names);
  std::vector<Sides> all(names.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    all[k].shared = std::move(shared[k]);
    all[k].separate = std::move(separate[k]);
  }
  return all;
}

}  // namespace

int run_team(const TeamOptions& options, const Run& run) {
  std::vector<Sides> all = make_sides(options.planners);
  Report report(run);
  Checker checker;
  {
    Progress progress("team", options.frames);
    for (std::uint64_t frame = 0; frame < options.frames + kWarmUpFrames; ++frame, progress.advance()) {
      std::mt19937_64 random(mixed(run.seed, frame));
      const TeamScene scene = eleven_against_eleven_team(random);
      for (const std::size_t k : rotated(all.size(), frame)) {
        Sides& sides = all[k];
        const bool shared_first = frame / all.size() % 2 == 0;
        double shared_us = shared_first ? plan_shared(sides, scene) : 0.0;
        const double separate_us = plan_separately(sides, scene);
        if (!shared_first) shared_us = plan_shared(sides, scene);
        check(sides, scene, checker);
        if (frame < kWarmUpFrames) continue;
        sides.shared_us.push_back(shared_us);
        sides.separate_us.push_back(separate_us);
      }
    }
  }
  report.add("team", table_of(all, checker));
  return report.finish(checker);
}

}  // namespace regista::bench
