// OMPL's samplers draw from generators that are seeded once in a process; these draw from the query's seed, so that
// an answer depends on its query alone.
#pragma once

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/samplers/InformedStateSampler.h>

#include "planning/planner.h"

namespace regista {

/// Uniform within the field's bounds.
class SeededSampler : public ompl::base::StateSampler {
 public:
  SeededSampler(const ompl::base::StateSpace* space, const Bounds& bounds, std::uint64_t seed)
      : StateSampler(space), bounds_(bounds), random_(seed) {}

  void sampleUniform(ompl::base::State* state) override;
  /// In the square of half that side around `near`, cut off at the bounds, as OMPL's sampler of real vectors does.
  void sampleUniformNear(ompl::base::State* state, const ompl::base::State* near, double distance) override;
  void sampleGaussian(ompl::base::State* state, const ompl::base::State* mean, double deviation) override;

 private:
  Bounds bounds_;
  std::mt19937_64 random_;
};

/// Uniform in the ellipse of all points over which a path from start to goal can be shorter than a given length
/// (Gammell, Srinivasa & Barfoot 2014), as far as it lies within the bounds.
class SeededEllipseSampler : public ompl::base::InformedSampler {
 public:
  SeededEllipseSampler(const ompl::base::ProblemDefinitionPtr& problem, unsigned int calls_max, const Bounds& bounds,
                       const Query& query);

  bool sampleUniform(ompl::base::State* state, const ompl::base::Cost& length_max) override;
  bool sampleUniform(ompl::base::State* state, const ompl::base::Cost& length_min,
                     const ompl::base::Cost& length_max) override;
  bool hasInformedMeasure() const override { return true; }
  double getInformedMeasure(const ompl::base::Cost& length) const override;
  ompl::base::Cost heuristicSolnCost(const ompl::base::State* state) const override;

 private:
  Bounds bounds_;
  Vec2 start_;
  Vec2 goal_;
  std::mt19937_64 random_;
};

/// The length of the path, with the sampler above.
class SeededPathLength : public ompl::base::PathLengthOptimizationObjective {
 public:
  SeededPathLength(const ompl::base::SpaceInformationPtr& information, const Bounds& bounds, const Query& query);

  ompl::base::InformedSamplerPtr allocInformedStateSampler(const ompl::base::ProblemDefinitionPtr& problem,
                                                           unsigned int calls_max) const override;

 private:
  Bounds bounds_;
  const Query& query_;
};

}  // namespace regista
