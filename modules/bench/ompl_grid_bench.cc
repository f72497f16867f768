#include "modules/bench/ompl_grid_bench.h"

#include <fmt/core.h>

#include <algorithm>

#include "modules/bench/bench.h"
#include "modules/bench/grid.h"
#include "modules/bench/reference.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

const std::string kQualified = "qualified";

/// A setting in the race. It leaves as soon as it cannot qualify any more: failures and excess lengths only add up.
struct Runner {
  Setting setting;
  Contender contender;
  std::vector<double> time_us;
  std::vector<double> blocked_us;  ///< of these, where the straight line is blocked: there the planner has to search
  std::size_t failures = 0;
  std::size_t answers = 0;
  double excess = 0.0;  ///< sum of length ratio - 1
  std::string out;      ///< why it left the race; "" while it is in

  double success() const { return static_cast<double>(answers) / static_cast<double>(answers + failures); }
  double ratio() const { return 1.0 + excess / static_cast<double>(answers); }
  double mean_us() const { return summarise(time_us).mean; }
};

class Race {
 public:
  Race(const GridOptions& options, const Run& run)
      : options_(options), run_(run), reference_(std::move(make_contenders({reference_planner()}).front())) {
    for (Setting& setting : load_grid(options.grid.empty() ? data_file("ompl_grid.toml") : options.grid)) {
      Contender contender{setting.planner, make_planner(setting.planner, setting.planning_params())};
      runners_.push_back({std::move(setting), std::move(contender), {}, {}, 0, 0, 0.0, {}});
    }
    if (runners_.empty()) throw std::runtime_error("the grid names no planner");
  }

  int measure() {
    Report report(run_);
    warm_up();
    race();
    for (Runner& runner : runners_) {
      if (!runner.out.empty()) continue;
      judge(runner, static_cast<double>(asked_));
      if (runner.out.empty()) runner.out = kQualified;
    }
    std::stable_sort(runners_.begin(), runners_.end(), [](const Runner& a, const Runner& b) {
      return (a.out == kQualified) > (b.out == kQualified) ||
             ((a.out == kQualified) == (b.out == kQualified) && a.mean_us() < b.mean_us());
    });
    report.add("ompl_grid", settings_table());
    report.add("ompl_grid_ratio", result_table());
    return report.finish(checker_);
  }

 private:
  struct Question {
    Scene scene;
    double length_m = 0.0;  ///< of the reference's answer
    bool is_blocked = false;
  };

  /// Until all queries are asked or the time is over.
  void race() {
    const SingleShot since;
    Progress progress("ompl-grid", options_.queries);
    for (std::uint64_t round = 0; asked_ < options_.queries && since.s() < options_.for_s; ++round) {
      const std::vector<Question> batch = next_batch();
      for (const std::size_t k : rotated(runners_.size(), round)) {
        for (const Question& question : batch) {
          if (runners_[k].out.empty()) ask(runners_[k], question);
        }
      }
      progress.advance(batch.size());
    }
  }

  /// The reference reuses its memory, which it has to get first; OMPL's planners get theirs anew for every query.
  void warm_up() {
    constexpr std::uint64_t kQueries = 100;
    for (std::uint64_t i = 0; i < kQueries; ++i) {
      std::mt19937_64 random(mixed(~run_.seed, i));
      const Scene scene = eleven_against_eleven(random);
      plan_once(reference_, scene.world, scene.request);
    }
  }

  /// Scenes that have a way, as the reference, whose turn this is, has found out.
  std::vector<Question> next_batch() {
    std::vector<Scene> scenes;
    for (std::size_t i = 0; i < std::min(options_.batch, options_.queries - asked_); ++i) {
      std::mt19937_64 random(mixed(run_.seed, scenes_++));
      scenes.push_back(eleven_against_eleven(random));
      scenes.back().request.budget.iterations = kUnlimitedIterations;
    }
    std::vector<Question> batch;
    for (Scene& scene : scenes) {
      const Shot shot = plan_once(reference_, scene.world, scene.request);
      const Plan& answer = reference_.answer;
      if (answer.status != PlanStatus::ok || answer.length_m == 0.0) continue;
      reference_us_.push_back(shot.total_us);
      const bool is_blocked = answer.path.size() > 2;
      if (is_blocked) reference_blocked_us_.push_back(shot.total_us);
      reference_answers_.push_back(answer);
      batch.push_back({std::move(scene), answer.length_m, is_blocked});
    }
    for (std::size_t i = 0; i < batch.size(); ++i) {
      checker_.check(reference_.name, batch[i].scene.world, batch[i].scene.request, reference_answers_[i]);
    }
    reference_answers_.clear();
    asked_ += batch.size();
    return batch;
  }

  void ask(Runner& runner, const Question& question) {
    Contender& contender = runner.contender;
    const Scene& scene = question.scene;
    const double time_us = plan_once(contender, scene.world, scene.request, runner.setting.time_us).total_us;
    runner.time_us.push_back(time_us);
    if (question.is_blocked) runner.blocked_us.push_back(time_us);
    const bool fine = checker_.check(contender.name, scene.world, scene.request, contender.answer);
    if (fine && contender.answer.status == PlanStatus::ok) {
      ++runner.answers;
      runner.excess += contender.answer.length_m / question.length_m - 1.0;
    } else {
      ++runner.failures;
    }
    judge(runner, static_cast<double>(options_.queries));
  }

  /// Puts it out of the race where it could not qualify even if all the rest of so many queries went perfectly.
  void judge(Runner& runner, double queries) const {
    if (static_cast<double>(runner.failures) > (1.0 - options_.success_min) * queries * (1.0 + 1e-9)) {
      runner.out = "fails too often";
    } else if (runner.excess > (options_.length_ratio_max - 1.0) * queries) {
      runner.out = "too long";
    }
  }

  Table settings_table() const {
    Table table{fmt::format("ompl-grid: settings of OMPL's planners on 11 against 11; to qualify: mean length ratio to "
                            "{} <= {}, success >= {:.1f} %, over {} queries",
                            reference_.name, options_.length_ratio_max, 100.0 * options_.success_min, asked_),
                {{"planner"},
                 {"setting"},
                 {"limit", "us"},
                 {"queries"},
                 {"success", "%", 5},
                 {"length mean", "x", 5},
                 {"time mean", "us"},
                 {"p50", "us"},
                 {"p99", "us"},
                 {"blocked mean", "us"},
                 {"result"}}};
    for (const Runner& runner : runners_) {
      const Summary time = summarise(runner.time_us);
      table.add({runner.setting.planner, runner.setting.text(), runner.setting.time_us, count_cell(time.count),
                 100.0 * runner.success(), runner.answers > 0 ? Cell{runner.ratio()} : Cell{}, time.mean, time.p50,
                 time.p99, summarise(runner.blocked_us).mean, runner.out});
    }
    table.notes = {
        fmt::format("single shots, all building included; each setting and the reference get {} quer{} in a row",
                    options_.batch, options_.batch == 1 ? "y" : "ies"),
        "a setting that cannot qualify any more gets no more queries",
        "blocked mean: of the queries whose straight line is blocked; the others need no search"};
    return table;
  }

  Table result_table() const {
    Table table{"ompl-grid: the fastest setting that qualifies, and the exact planner in the same run",
                {{"planner"},
                 {"setting"},
                 {"time mean", "us"},
                 {"p50", "us"},
                 {"p99", "us"},
                 {"times slower", "x"},
                 {"blocked mean", "us"},
                 {"times slower there", "x"}}};
    const Summary reference = summarise(reference_us_);
    const double blocked_us = summarise(reference_blocked_us_).mean;
    table.add({reference_.name, std::string(), reference.mean, reference.p50, reference.p99, 1.0, blocked_us, 1.0});
    const Runner* best = &runners_.front();
    if (best->out != kQualified) {
      best = &*std::max_element(runners_.begin(), runners_.end(),
                                [](const Runner& a, const Runner& b) { return a.time_us.size() < b.time_us.size(); });
      table.notes = {fmt::format("no setting qualifies; this one stayed longest, {} of {} queries: {}",
                                 best->time_us.size(), asked_, best->out)};
    }
    const Summary time = summarise(best->time_us);
    const double best_blocked_us = summarise(best->blocked_us).mean;
    table.add({best->setting.planner, fmt::format("{}, limit {} us", best->setting.text(), best->setting.time_us),
               time.mean, time.p50, time.p99, time.mean / reference.mean, best_blocked_us,
               best_blocked_us / blocked_us});
    return table;
  }

  GridOptions options_;
  Run run_;
  Contender reference_;
  std::vector<Runner> runners_;
  std::vector<double> reference_us_, reference_blocked_us_;
  std::vector<Plan> reference_answers_;  ///< of the batch, until they are checked
  std::uint64_t scenes_ = 0;             ///< made so far
  std::size_t asked_ = 0;                ///< those that have a way
  Checker checker_;
};

}  // namespace

int run_ompl_grid(const GridOptions& options, const Run& run) { return Race(options, run).measure(); }

}  // namespace regista::bench
