#include "planning/planners/ompl/seeded_samplers.h"

#include <algorithm>
#include <numbers>

#include "planning/planners/ompl/exact_checks.h"
#include "planning/planners/rrt_tree.h"

namespace regista {
namespace {

/// Streams of one query's seed; the planners' own generators have further ones.
constexpr std::uint64_t kEllipseStream = 101;

/// Tries of the ellipse sampler for a point within the bounds. A quarter of the ellipse or more is, wherever its foci
/// are; OMPL itself allows BIT* four billion.
constexpr unsigned int kTriesMax = 1000;

/// Of the uniform distribution on the unit disc, by rejection: no trigonometry, so the same everywhere.
Vec2 point_in_unit_disc(std::mt19937_64& random) {
  while (true) {
    const double x = uniform(random, -1.0, 1.0);
    const double y = uniform(random, -1.0, 1.0);
    if (x * x + y * y <= 1.0) return {x, y};
  }
}

/// The ellipse's lesser diameter.
double width_of_ellipse(double length, double focal_distance) {
  return std::sqrt(std::max(0.0, length * length - focal_distance * focal_distance));
}

}  // namespace

void SeededSampler::sampleUniform(ompl::base::State* state) { set_point(state, uniform_point(random_, bounds_)); }

void SeededSampler::sampleUniformNear(ompl::base::State* state, const ompl::base::State* near, double distance) {
  const Vec2 middle = point_of(near);
  const double x = uniform(random_, -distance, distance);
  const double y = uniform(random_, -distance, distance);
  const Vec2& half = bounds_.half_extent_m;
  set_point(state, (middle + Vec2(x, y)).cwiseMax(-half).cwiseMin(half));
}

void SeededSampler::sampleGaussian(ompl::base::State*, const ompl::base::State*, double) {
  throw std::logic_error("no planner of the registry samples normally distributed states");
}

SeededEllipseSampler::SeededEllipseSampler(const ompl::base::ProblemDefinitionPtr& problem, unsigned int calls_max,
                                           const Bounds& bounds, const Query& query)
    : InformedSampler(problem, std::min(calls_max, kTriesMax)),
      bounds_(bounds),
      start_(query.start),
      goal_(query.goal),
      random_(mixed(query.seed, kEllipseStream)) {}

bool SeededEllipseSampler::sampleUniform(ompl::base::State* state, const ompl::base::Cost& length_max) {
  if (!std::isfinite(length_max.value())) {
    set_point(state, uniform_point(random_, bounds_));
    return true;
  }
  const Vec2 way = goal_ - start_;
  const double distance = way.norm();
  const Vec2 half_along = way * (0.5 * length_max.value() / distance);
  const Vec2 half_across = Vec2(-way.y(), way.x()) * (0.5 * width_of_ellipse(length_max.value(), distance) / distance);
  for (unsigned int i = 0; i < numIters_; ++i) {
    const Vec2 unit = point_in_unit_disc(random_);
    const Vec2 point = 0.5 * (start_ + goal_) + unit.x() * half_along + unit.y() * half_across;
    if (!is_inside(point, bounds_)) continue;
    set_point(state, point);
    return true;
  }
  set_point(state, start_);
  return false;
}

bool SeededEllipseSampler::sampleUniform(ompl::base::State* state, const ompl::base::Cost& length_min,
                                         const ompl::base::Cost& length_max) {
  for (unsigned int i = 0; i < numIters_; ++i) {
    if (sampleUniform(state, length_max) && heuristicSolnCost(state).value() >= length_min.value()) return true;
  }
  return false;
}

double SeededEllipseSampler::getInformedMeasure(const ompl::base::Cost& length) const {
  const double field = 4.0 * bounds_.half_extent_m.prod();
  if (!std::isfinite(length.value())) return field;
  const double width = width_of_ellipse(length.value(), (goal_ - start_).norm());
  return std::min(field, std::numbers::pi / 4.0 * length.value() * width);
}

ompl::base::Cost SeededEllipseSampler::heuristicSolnCost(const ompl::base::State* state) const {
  const Vec2 point = point_of(state);
  return ompl::base::Cost((point - start_).norm() + (goal_ - point).norm());
}

SeededPathLength::SeededPathLength(const ompl::base::SpaceInformationPtr& information, const Bounds& bounds,
                                   const Query& query)
    : PathLengthOptimizationObjective(information), bounds_(bounds), query_(query) {
  setCostToGoHeuristic(&ompl::base::goalRegionCostToGo);
}

ompl::base::InformedSamplerPtr SeededPathLength::allocInformedStateSampler(
    const ompl::base::ProblemDefinitionPtr& problem, unsigned int calls_max) const {
  return std::make_shared<SeededEllipseSampler>(problem, calls_max, bounds_, query_);
}

}  // namespace regista
