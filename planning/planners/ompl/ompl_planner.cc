#include "planning/planners/ompl/ompl_planner.h"

#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Console.h>

#include "planning/planners/ompl/exact_checks.h"
#include "planning/planners/ompl/seeded_planners.h"
#include "planning/planners/ompl/seeded_samplers.h"
#include "planning/uniform.h"

namespace regista {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

/// Streams of one query's seed for the samplers of the space, of which OMPL may want several.
constexpr std::uint64_t kSamplerStream = 1;

/// The field as OMPL's state space. Its bounds are wider than ours by more than touching them allows: OMPL refuses
/// starts and goals outside.
ob::StateSpacePtr make_space(const Bounds& bounds, std::uint64_t seed) {
  auto space = std::make_shared<ob::RealVectorStateSpace>(2U);
  ob::RealVectorBounds box(2U);
  for (unsigned int axis = 0; axis < 2; ++axis) {
    const double half = bounds.half_extent_m[static_cast<Eigen::Index>(axis)] + 2.0 * kTouch_m;
    box.setLow(axis, -half);
    box.setHigh(axis, half);
  }
  space->setBounds(box);
  space->setStateSamplerAllocator([bounds, seed, stream = kSamplerStream](const ob::StateSpace* of) mutable {
    return std::make_shared<SeededSampler>(of, bounds, mixed(seed, stream++));
  });
  return space;
}

ob::SpaceInformationPtr make_information(const ObstacleField& field, const Query& query) {
  auto information = std::make_shared<ob::SpaceInformation>(make_space(field.bounds(), query.seed));
  information->setStateValidityChecker(std::make_shared<ExactStates>(information, field, query));
  information->setMotionValidator(std::make_shared<ExactMotions>(information, field, query));
  information->setup();
  return information;
}

ob::ProblemDefinitionPtr make_problem(const ob::SpaceInformationPtr& information, const ObstacleField& field,
                                      const Query& query, double stop_length_m) {
  auto problem = std::make_shared<ob::ProblemDefinition>(information);
  ob::ScopedState<> start(information);
  ob::ScopedState<> goal(information);
  set_point(start.get(), query.start);
  set_point(goal.get(), query.goal);
  problem->setStartAndGoalStates(start, goal);
  const auto objective = std::make_shared<SeededPathLength>(information, field.bounds(), query);
  objective->setCostThreshold(ob::Cost(stop_length_m));
  problem->setOptimizationObjective(objective);
  return problem;
}

/// Counts its evaluations; when the budget is spent it stays spent and nobody is asked for the time again.
class Termination {
 public:
  explicit Termination(const Budget& budget) : budget_(budget) {}

  bool operator()() {
    if (!over_) over_ = evaluations_++ >= budget_.iterations || budget_.is_spent();
    return over_;
  }

 private:
  const Budget& budget_;
  std::int64_t evaluations_ = 0;
  bool over_ = false;
};

std::vector<Vec2> points_of(const og::PathGeometric& path) {
  std::vector<Vec2> points;
  points.reserve(path.getStateCount());
  for (std::size_t i = 0; i < path.getStateCount(); ++i) {
    points.push_back(point_of(path.getState(static_cast<unsigned int>(i))));
  }
  return points;
}

}  // namespace

OmplPlanner::OmplPlanner(OmplAlgorithm algorithm, const OmplParams& params) : algorithm_(algorithm), params_(params) {
  // The level is the process's, but nobody else uses OMPL here, and what it says on the console nobody asked for.
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
}

void OmplPlanner::search(graph::SharedGraph& graph, const Query& query, SearchResult& result) {
  const ObstacleField& field = graph.field();
  if (field.is_free(query.start, query.goal, query.ignored)) {
    result.path = {query.start, query.goal};
    result.status = PlanStatus::ok;
    return;
  }
  const ob::SpaceInformationPtr information = make_information(field, query);
  const ob::ProblemDefinitionPtr problem = make_problem(information, field, query, params_.stop_length_m);
  const ob::PlannerPtr planner = make_seeded(algorithm_, information, params_, query.seed);
  planner->setProblemDefinition(problem);
  planner->setup();
  Termination termination(query.budget);
  const ob::PlannerTerminationCondition condition([&termination] { return termination(); });
  const ob::PlannerStatus status = planner->solve(condition);
  if (ob::PathPtr path = problem->getSolutionPath()) {
    og::PathGeometric& geometric = *path->as<og::PathGeometric>();
    if (params_.simplify) SeededSimplifier(information, query.seed).simplify(geometric, condition);
    result.path = points_of(geometric);
  }
  if (status == ob::PlannerStatus::EXACT_SOLUTION) {
    result.status = PlanStatus::ok;
  } else {
    result.reason = "no way within the budget";
  }
}

}  // namespace regista
