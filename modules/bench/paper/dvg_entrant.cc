#include "modules/bench/paper/dvg_entrant.h"

#include "planning/planners/rrt_tree.h"
#include "planning/polyline.h"

namespace regista::bench {
namespace {

/// A tree that finds nothing is followed by another one, so often; no time is lost for a goal that cannot be reached.
constexpr std::size_t kTriesMax = 20;

class PublishedDvg : public Entrant {
 public:
  PublishedDvg(const std::string& name, const DvgParams& params) : Entrant(name), params_(params) {}

  Attempt plan(const ObjectsQuery& query, std::uint64_t, double budget_us) override {
    const SingleShot shot;
    const std::function<bool()> out_of_time = [&] { return shot.us() >= budget_us; };
    Budget budget;
    if (budget_us > 0.0) budget.out_of_time = &out_of_time;
    dvg::find(query.objects, query.start, query.goal, params_, graph_, result_, budget);
    return {result_.end == dvg::End::goal, shot.us(), result_.path, 1};
  }

  void check(const ObjectsQuery& query, const Attempt& attempt, Checker& checker) const override {
    // No obstacle and no bounds: what is left of the laws are the ends and numbers.
    const World nothing{{Vec2::Constant(1e6)}, {}};
    PlanRequest request;
    request.start = query.start;
    request.goal = query.goal;
    const PlanStatus status = attempt.reached ? PlanStatus::ok : PlanStatus::not_found;
    checker.check(name(), nothing, request, {status, false, false, attempt.path, length_of(attempt.path), ""});
  }

 private:
  DvgParams params_;
  dvg::Graph graph_;
  dvg::Result result_;
};

/// Objects that cover an end reach as far as there, as in the published geometry of DVG.
ObjectsQuery uncovered(ObjectsQuery query) {
  for (dvg::Object& object : query.objects) {
    const double to_end_m = std::min((query.start - object.centre).norm(), (query.goal - object.centre).norm());
    object.radius_m = std::min(object.radius_m, to_end_m);
  }
  return query;
}

class PublishedRrt : public Entrant {
 public:
  PublishedRrt(const std::string& name, const RrtParams& params) : Entrant(name), params_(params) {}

  Attempt plan(const ObjectsQuery& query, std::uint64_t seed, double budget_us) override {
    const World world = world_of(uncovered(query));
    const RrtSteps steps{params_.step_m, params_.goal_reach_m, true, static_cast<std::size_t>(params_.leaf_size)};
    const SingleShot shot;
    const std::function<bool()> out_of_time = [&] { return shot.us() >= budget_us; };
    Query asked{query.start, query.goal, {}, seed, {}, {}};
    if (budget_us > 0.0) asked.budget.out_of_time = &out_of_time;
    const ObstacleField field(world.bounds, world.obstacles);
    std::mt19937_64 random(seed);
    Attempt attempt{false, 0.0, {}, 0};
    while (!attempt.reached && !asked.budget.is_spent() && (budget_us > 0.0 || attempt.tries < kTriesMax)) {
      RrtBranch branch =
          grow_rrt(field, asked, steps, query.rrt_samples, [&] { return uniform_point(random, field.bounds()); });
      ++attempt.tries;
      attempt.reached = branch.end == RrtEnd::goal;
      if (attempt.path.empty() || attempt.reached ||
          distance_m(query.goal, branch.path) < distance_m(query.goal, attempt.path)) {
        attempt.path = pruned(field, branch.path, {});
      }
    }
    attempt.time_us = shot.us();
    return attempt;
  }

  void check(const ObjectsQuery& query, const Attempt& attempt, Checker& checker) const override {
    PlanRequest request;
    request.start = query.start;
    request.goal = query.goal;
    const PlanStatus status = attempt.reached ? PlanStatus::ok : PlanStatus::not_found;
    checker.check(name(), world_of(uncovered(query)), request,
                  {status, false, false, attempt.path, length_of(attempt.path), ""});
  }

 private:
  RrtParams params_;
};

class Registered : public Entrant {
 public:
  explicit Registered(const std::string& planner)
      : Entrant(planner), contender_(std::move(make_contenders({planner}).front())) {}

  Attempt plan(const ObjectsQuery& query, std::uint64_t seed, double budget_us) override {
    const World world = world_of(query);
    const Shot shot = plan_once(contender_, world, request_of(query, seed), budget_us);
    return {contender_.answer.status == PlanStatus::ok, shot.total_us, contender_.answer.path, 1};
  }

  void check(const ObjectsQuery& query, const Attempt&, Checker& checker) const override {
    checker.check(name(), world_of(query), request_of(query, 0), contender_.answer);
  }

 private:
  static PlanRequest request_of(const ObjectsQuery& query, std::uint64_t seed) {
    PlanRequest request;
    request.start = query.start;
    request.goal = query.goal;
    request.seed = seed;
    request.budget.iterations = query.rrt_samples;
    return request;
  }

  Contender contender_;
};

}  // namespace

std::unique_ptr<Entrant> published_dvg(const std::string& name, const DvgParams& params) {
  return std::make_unique<PublishedDvg>(name, params);
}

std::unique_ptr<Entrant> published_rrt(const std::string& name, const RrtParams& params) {
  return std::make_unique<PublishedRrt>(name, params);
}

std::unique_ptr<Entrant> registered(const std::string& planner) { return std::make_unique<Registered>(planner); }

void add_ours(Entrants& entrants) {
  for (const char* planner : {"tangent", "visibility_sampling"}) {
    if (is_registered(planner)) entrants.push_back(registered(planner));
  }
}

Entrants dvg_and_rrt_and_ours() {
  Entrants entrants;
  entrants.push_back(published_dvg("dvg", {}));
  entrants.push_back(published_rrt("rrt", {}));
  add_ours(entrants);
  return entrants;
}

}  // namespace regista::bench
