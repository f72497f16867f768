#include "modules/bench/paper/dvg_static.h"

#include <fmt/core.h>

#include "planning/uniform.h"

namespace regista::bench {
namespace {

constexpr double kMsPerUs = 1e-3;
constexpr std::size_t kWarmUp = 3;  // rounds that are not counted: first touch of memory and code

/// What one entrant did.
struct Score {
  std::vector<double> time_ms, length_m, safety_m;
  std::size_t failures = 0;
  std::size_t touching = 0;  ///< answers on which the robot would touch another one
  std::size_t trees = 0;
};

void note(Score& score, const ObjectsQuery& query, const Attempt& attempt) {
  score.trees += attempt.tries;
  if (!attempt.reached) {
    ++score.failures;
    return;
  }
  score.time_ms.push_back(attempt.time_us * kMsPerUs);
  score.length_m.push_back(length_of(attempt.path));
  score.safety_m.push_back(safety_m(query.objects, attempt.path));
  if (touches_robot(query.objects, attempt.path)) ++score.touching;
}

}  // namespace

Published published_of(const std::string& table) {
  if (!table.empty()) return load_published("dvg_published.toml", table);
  Published none = load_published("dvg_published.toml", "table4");
  none.rows.clear();
  return none;
}

StaticSamples measure_static(Entrants& entrants, const ObjectsQuery& query, const std::string& where,
                             std::size_t samples, std::uint64_t seed, Checker& checker) {
  std::vector<Score> scores(entrants.size());
  for (std::size_t i = 0; i < samples + kWarmUp; ++i) {
    for (const std::size_t k : rotated(entrants.size(), i)) {
      const Attempt attempt = entrants[k]->plan(query, mixed(mixed(seed, i), k), 0.0);
      entrants[k]->check(query, attempt, checker);
      if (i >= kWarmUp) note(scores[k], query, attempt);
    }
  }
  StaticSamples out;
  for (std::size_t k = 0; k < entrants.size(); ++k) {
    const std::string& who = entrants[k]->name();
    Score& score = scores[k];
    const std::size_t found = score.time_ms.size();
    out.sampled.push_back({where, "time", who, std::move(score.time_ms), score.failures});
    out.sampled.push_back({where, "length", who, std::move(score.length_m), score.failures});
    out.sampled.push_back({where, "safety", who, std::move(score.safety_m), score.failures});
    if (score.touching > 0) {
      out.notes.push_back(
          fmt::format("{}: {} of {} paths come nearer to a robot than 180 mm: octagons cut corners, "
                      "and the last edge is allowed 90 mm",
                      who, score.touching, found));
    }
    if (score.trees > samples) {
      out.notes.push_back(fmt::format("{}: {} trees grown for {} samples", who, score.trees, samples));
    }
  }
  return out;
}

int run_static_test(const StaticTest& test, Entrants entrants, const PaperOptions& options, const Run& run) {
  const DvgScenario scenario = load_dvg_scenario(test.scenario);
  const Published published = published_of(test.table);
  const std::size_t samples = options.samples > 0 ? options.samples : published.samples;
  Report report(run);
  Checker checker;
  const StaticSamples measured = measure_static(entrants, query_of(scenario), "", samples, run.seed, checker);
  Table table = comparison(test.title, published, measured.sampled);
  table.notes = {"rebuilt, not tuned on results: " + scenario.rebuilt,
                 "published on an i7-9750H; time: single shots, from the objects to the path",
                 "safety: sum over the objects of the distance from centre to path",
                 "dvg and rrt as published; the others on exact discs of the same radii, checked by clearance; of dvg "
                 "only the ends are, its geometry is not the exact one"};
  for (const auto* notes : {&test.notes, &measured.notes}) {
    table.notes.insert(table.notes.end(), notes->begin(), notes->end());
  }
  report.add(test.stem, table);
  for (const char* what : {"time", "length", "safety"}) {
    Plot plot = boxes(test.title + ": " + what, "", what, published, measured.sampled);
    if (std::string(what) == "time") plot.y = {plot.y.label, plot.y.unit, true};
    if (!plot.boxes.empty()) report.add(test.stem + "_" + what, plot);
  }
  return report.finish(checker);
}

}  // namespace regista::bench
