// OMPL's planners with their generators seeded from the query and their parameters set.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/geometric/PathSimplifier.h>

#include "planning/planners/ompl/ompl_params.h"
#include "planning/planners/ompl/ompl_planner.h"

namespace regista {

ompl::base::PlannerPtr make_seeded(OmplAlgorithm algorithm, const ompl::base::SpaceInformationPtr& information,
                                   const OmplParams& params, std::uint64_t seed);

class SeededSimplifier : public ompl::geometric::PathSimplifier {
 public:
  SeededSimplifier(const ompl::base::SpaceInformationPtr& information, std::uint64_t seed);
};

}  // namespace regista
