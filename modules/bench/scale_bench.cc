#include "modules/bench/scale_bench.h"

#include "modules/bench/scale_parts.h"
#include "planning/uniform.h"

namespace regista::bench {

Scale::Scale(const ScaleOptions& options, const Run& run) : options_(options), run_(run), report_(run) {
  const std::size_t sizes = options_.obstacles.size() + options_.robots.size() + options_.crowds.size();
  share_s_ = options_.for_s / static_cast<double>(sizes * contenders(true).size());
}

Contenders Scale::contenders(bool with_comparison) const {
  if (!options_.planners.empty()) return make_contenders(options_.planners);
  std::vector<std::string> names;
  for (const char* name : {"tangent", "visibility_sampling"}) {
    if (is_registered(name)) names.emplace_back(name);
  }
  if (with_comparison) names.emplace_back("rrt");
  return make_contenders(names);
}

std::mt19937_64 Scale::random_of(ScalePart part, std::size_t count, std::uint64_t round) const {
  return std::mt19937_64(mixed(mixed(mixed(run_.seed, static_cast<std::uint64_t>(part)), count), round));
}

Scale::Frame Scale::plan_frame(Contender& contender, const TeamScene& scene, double left_s, ScaleSample& sample) {
  Frame frame;
  const std::vector<Obstacle> obstacles = scene.world.obstacles;  // as if just made
  answers_.resize(std::max(answers_.size(), scene.requests.size()));
  frame.each_us.reserve(scene.requests.size());
  contender.graph.clear();
  const SingleShot since;
  contender.graph.reset(scene.world.bounds, obstacles);
  frame.set_up_us = since.us();
  frame.total_us = frame.set_up_us;
  for (std::size_t i = 0; i < scene.requests.size(); ++i) {
    if (i > 0 && since.s() > left_s) break;
    const SingleShot query;
    contender.planner->plan(contender.graph, scene.requests[i], answers_[i]);
    frame.each_us.push_back(query.us());
    frame.total_us += frame.each_us.back();
  }
  for (std::size_t i = 0; i < frame.each_us.size(); ++i) {
    check(contender.name, scene.world, scene.requests[i], answers_[i], sample);
  }
  return frame;
}

void Scale::check(const std::string& planner, const World& world, const PlanRequest& request, const Plan& answer,
                  ScaleSample& sample) {
  const bool fine = checker_.check(planner, world, request, answer);
  sample.solved += fine && answer.status == PlanStatus::ok ? 1U : 0U;
  sample.unreachable += answer.status == PlanStatus::unreachable ? 1U : 0U;
}

Series goal_line(const std::string& name, double level, const std::vector<std::size_t>& sizes) {
  Series line{name, {}, Series::Style::dashes};
  for (const std::size_t size : sizes) line.points.push_back({static_cast<double>(size), level});
  return line;
}

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

int run_scale(const ScaleOptions& options, const Run& run) {
  Scale scale(options, run);
  scale.measure_obstacles();
  scale.measure_fleets();
  scale.measure_crowds();
  return scale.finish();
}

}  // namespace regista::bench
