// What the three parts of `regista bench scale` share; for the files scale_*.cc alone.
#pragma once

#include <algorithm>

#include "modules/bench/bench.h"
#include "modules/bench/scale_bench.h"

namespace regista::bench {

/// The part is mixed into the seed, so that parts of equal counts do not see the same worlds.
enum class ScalePart : std::uint64_t { obstacles, fleets, crowds };

/// What one planner took at one size.
struct ScaleSample {
  std::vector<double> set_up_us;  ///< per frame
  std::vector<double> each_us;    ///< per query
  std::vector<double> frame_ms;   ///< per whole frame
  std::size_t solved = 0;
  std::size_t unreachable = 0;  ///< proved to have no way
  double spent_s = 0.0;
};

class Scale {
 public:
  Scale(const ScaleOptions& options, const Run& run);

  void measure_obstacles();
  void measure_fleets();
  void measure_crowds();
  int finish() { return report_.finish(checker_); }

 private:
  struct Frame {
    double set_up_us = 0.0;
    double total_us = 0.0;
    std::vector<double> each_us;  ///< per request answered
  };

  /// Those asked for; else the planners of the shared graph, and one to compare with.
  Contenders contenders(bool with_comparison) const;
  std::mt19937_64 random_of(ScalePart part, std::size_t count, std::uint64_t round) const;

  /// One graph for all requests, answers checked; stops when `left_s` are over, but not before the first answer.
  Frame plan_frame(Contender& contender, const TeamScene& scene, double left_s, ScaleSample& sample);
  void check(const std::string& planner, const World& world, const PlanRequest& request, const Plan& answer,
             ScaleSample& sample);

  /// Rounds of all planners in turn, `once(contender, sample, round)`, until each has `wanted` queries or has used its
  /// share of the time.
  template <class Once>
  std::vector<ScaleSample> rounds(Contenders& all, std::size_t wanted, Once&& once) const {
    std::vector<ScaleSample> samples(all.size());
    const auto is_done = [&](const ScaleSample& s) { return s.each_us.size() >= wanted || s.spent_s >= share_s_; };
    for (std::uint64_t round = 0; !std::all_of(samples.begin(), samples.end(), is_done); ++round) {
      for (const std::size_t k : rotated(all.size(), round)) {
        if (is_done(samples[k])) continue;
        const SingleShot since;
        once(all[k], samples[k], round);
        samples[k].spent_s += since.s();
      }
    }
    return samples;
  }

  ScaleOptions options_;
  Run run_;
  Report report_;
  Checker checker_;
  std::vector<Plan> answers_;  ///< of a frame, checked when it is over
  double share_s_ = 0.0;       ///< per planner and size
};

/// A level to reach, drawn over all sizes.
Series goal_line(const std::string& name, double level, const std::vector<std::size_t>& sizes);

double percent(std::size_t part, std::size_t whole);

}  // namespace regista::bench
