// The planners taken from the Open Motion Planning Library (Sucan, Moll & Kavraki 2012), through one adapter with our
// exact motion check. Only this folder sees OMPL.
#pragma once

#include "planning/planner.h"
#include "planning/planning_params.h"

namespace regista {

enum class OmplAlgorithm { rrt_star, fmt_star, bit_star, rrt_connect, informed_rrt_star };

/// Everything of OMPL is made anew for each query and all its random numbers come from the query's seed: the same bytes
/// again, for one build. The budget's iterations are evaluations of OMPL's termination condition: a sample of the RRT
/// kind, an edge of BIT*, a sample or an expanded node of FMT*. The anytime planners use all of them and answer the
/// best path. A free straight line is answered at once: it is what they would converge to. When a search ends without
/// the goal, the approximate path that it may have is the answer's.
class OmplPlanner : public Planner {
 protected:
  OmplPlanner(OmplAlgorithm algorithm, const OmplParams& params);
  void search(graph::SharedGraph& graph, const Query& query, SearchResult& result) override;

 private:
  OmplAlgorithm algorithm_;
  OmplParams params_;
};

template <OmplAlgorithm algorithm>
class OmplPlannerOf : public OmplPlanner {
 public:
  explicit OmplPlannerOf(const OmplParams& params) : OmplPlanner(algorithm, params) {}
  explicit OmplPlannerOf(const PlanningParams& params = {}) : OmplPlanner(algorithm, params.ompl) {}
};

using RrtStar = OmplPlannerOf<OmplAlgorithm::rrt_star>;                   ///< Karaman & Frazzoli 2011
using FmtStar = OmplPlannerOf<OmplAlgorithm::fmt_star>;                   ///< Janson et al. 2015
using BitStar = OmplPlannerOf<OmplAlgorithm::bit_star>;                   ///< Gammell, Srinivasa & Barfoot 2015
using RrtConnect = OmplPlannerOf<OmplAlgorithm::rrt_connect>;             ///< Kuffner & LaValle 2000
using InformedRrtStar = OmplPlannerOf<OmplAlgorithm::informed_rrt_star>;  ///< Gammell, Srinivasa & Barfoot 2014

}  // namespace regista
