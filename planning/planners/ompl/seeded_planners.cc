#include "planning/planners/ompl/seeded_planners.h"

#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/informedtrees/bitstar/ImplicitGraph.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include "planning/planners/ompl/seeded_gnat.h"
#include "planning/uniform.h"

// BIT* declares a setter for its structure of nearest neighbours, but OMPL 1.5 defines it in no header; these are its
// specialisations for ours.
namespace ompl::geometric {

template <>
void BITstar::ImplicitGraph::setNearestNeighbors<regista::SeededGnat>() {
  samples_ = std::make_shared<regista::SeededGnat<VertexPtr>>();
}

template <>
void BITstar::setNearestNeighbors<regista::SeededGnat>() {
  graphPtr_->setNearestNeighbors<regista::SeededGnat>();
}

}  // namespace ompl::geometric

namespace regista {
namespace {

/// Streams of one query's seed; the samplers have further ones.
constexpr std::uint64_t kPlannerStream = 201;
constexpr std::uint64_t kSimplifierStream = 202;

/// OMPL's generators take 32 bits.
std::uint_fast32_t local_seed(std::uint64_t seed, std::uint64_t stream) { return mixed(seed, stream) >> 32; }

/// RRT* or a kind of it.
template <class Base>
struct SeededRrtStar : Base {
  SeededRrtStar(const ompl::base::SpaceInformationPtr& information, const OmplParams& params, std::uint64_t seed)
      : Base(information) {
    this->rng_.setLocalSeed(local_seed(seed, kPlannerStream));
    this->nn_ = std::make_shared<SeededGnat<typename Base::Motion*>>();
    this->setRange(params.range_m);
    this->setGoalBias(params.goal_bias);
  }
};

struct SeededRrtConnect : ompl::geometric::RRTConnect {
  SeededRrtConnect(const ompl::base::SpaceInformationPtr& information, const OmplParams& params, std::uint64_t seed)
      : RRTConnect(information) {
    rng_.setLocalSeed(local_seed(seed, kPlannerStream));
    tStart_ = std::make_shared<SeededGnat<Motion*>>();
    tGoal_ = std::make_shared<SeededGnat<Motion*>>();
    setRange(params.range_m);
  }
};

/// Draws from the space's sampler alone.
struct SeededFmt : ompl::geometric::FMT {
  SeededFmt(const ompl::base::SpaceInformationPtr& information, const OmplParams& params) : FMT(information) {
    nn_ = std::make_shared<SeededGnat<Motion*>>();
    setNumSamples(static_cast<unsigned int>(params.samples_per_batch));
  }
};

}  // namespace

ompl::base::PlannerPtr make_seeded(OmplAlgorithm algorithm, const ompl::base::SpaceInformationPtr& information,
                                   const OmplParams& params, std::uint64_t seed) {
  switch (algorithm) {
    case OmplAlgorithm::rrt_star:
      return std::make_shared<SeededRrtStar<ompl::geometric::RRTstar>>(information, params, seed);
    case OmplAlgorithm::informed_rrt_star:
      return std::make_shared<SeededRrtStar<ompl::geometric::InformedRRTstar>>(information, params, seed);
    case OmplAlgorithm::rrt_connect:
      return std::make_shared<SeededRrtConnect>(information, params, seed);
    case OmplAlgorithm::fmt_star:
      return std::make_shared<SeededFmt>(information, params);
    case OmplAlgorithm::bit_star:
      break;
  }
  // Draws from the objective's sampler alone as long as just-in-time sampling is off, which it is by default.
  auto bit_star = std::make_shared<ompl::geometric::BITstar>(information);
  bit_star->setNearestNeighbors<SeededGnat>();
  bit_star->setSamplesPerBatch(static_cast<unsigned int>(params.samples_per_batch));
  return bit_star;
}

SeededSimplifier::SeededSimplifier(const ompl::base::SpaceInformationPtr& information, std::uint64_t seed)
    : PathSimplifier(information) {
  rng_.setLocalSeed(local_seed(seed, kSimplifierStream));
}

}  // namespace regista
