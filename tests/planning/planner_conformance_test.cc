// Every planner of the registry keeps the laws, and planners that do not are caught. A new planner is examined without
// a line here.
#include <catch2/catch.hpp>

#include "planning/graph/visibility_search.h"
#include "tests/support/planning_conformance.h"
#include "tests/support/share.h"

namespace regista {
namespace {

constexpr int kWorlds = testing::share_of(1000);
constexpr int kWorldsForFakes = 50;
constexpr Guarantees kDeterministic{false, false, true, false};

/// Straight ahead, whatever stands there.
class Reckless : public Planner {
 protected:
  void search(graph::SharedGraph&, const Query& query, SearchResult& result) override {
    result.status = PlanStatus::ok;
    result.path = {query.start, query.goal};
  }
};

/// Stops a millimetre short.
class Inexact : public Planner {
 protected:
  void search(graph::SharedGraph&, const Query& query, SearchResult& result) override {
    result.status = PlanStatus::ok;
    result.path = {query.start, query.goal + Vec2(1e-3, 0)};
  }
};

/// Searches until it has found, whatever the budget says.
class IgnoresBudget : public Planner {
 protected:
  void search(graph::SharedGraph& graph, const Query& query, SearchResult& result) override {
    Query patient = query;
    patient.budget = {};
    const bool found = search_.find(graph, patient, result.path) == graph::VisibilitySearch::End::goal;
    result.status = found ? PlanStatus::ok : PlanStatus::not_found;
    if (!found) result.reason = "no way";
  }

 private:
  graph::VisibilitySearch search_;
};

/// The same, and it asks for the time, but searches on.
class IgnoresTheAnswer : public IgnoresBudget {
 protected:
  void search(graph::SharedGraph& graph, const Query& query, SearchResult& result) override {
    (void)query.budget.is_spent();
    IgnoresBudget::search(graph, query, result);
  }
};

/// Wraps a good planner and spoils its answers.
class Spoiled : public Planner {
 public:
  enum class How { forgets_the_reason, gives_up_early, remembers, prefers_left, marks_left };
  explicit Spoiled(How how) : how_(how) {}

 protected:
  void search(graph::SharedGraph& graph, const Query& query, SearchResult& result) override {
    PlanRequest request;
    request.start = query.start;
    request.goal = query.goal;
    request.ignored.assign(query.ignored.begin(), query.ignored.end());
    request.budget = query.budget;
    const Plan plan = good_->plan(graph, request);
    result = {plan.status, plan.path, plan.reason};
    ++calls_;
    switch (how_) {
      case How::forgets_the_reason:
        result.reason.clear();
        return;
      case How::gives_up_early:
        if (plan.status != PlanStatus::ok) result = {PlanStatus::unreachable, {}, "I think"};
        if (plan.path.size() > 2) result = {PlanStatus::unreachable, {}, "too many corners"};
        return;
      case How::remembers:
        if (calls_ % 2 == 0 && plan.status == PlanStatus::ok) {
          result.path.insert(result.path.begin() + 1, 0.5 * (plan.path[0] + plan.path[1]));
        }
        return;
      case How::prefers_left:
        if (plan.status == PlanStatus::ok && plan.path.size() > 2 && plan.path[1].y() < plan.path[0].y()) {
          result.path.insert(result.path.begin() + 1, {result.path[1], result.path[0]});
        }
        return;
      case How::marks_left:  // as long, but with a vertex more
        if (plan.status == PlanStatus::ok && plan.path.size() > 2 && plan.path[1].y() < plan.path[0].y()) {
          result.path.insert(result.path.begin() + 1, 0.5 * (plan.path[0] + plan.path[1]));
        }
        return;
    }
  }

 private:
  How how_;
  int calls_ = 0;
  std::unique_ptr<Planner> good_ = make_planner("visibility_sampling");
};

template <class P>
bool is_caught() {
  return !testing::broken_laws([] { return std::make_unique<P>(); }, kDeterministic, kWorldsForFakes).empty();
}

bool is_caught(Spoiled::How how) {
  return !testing::broken_laws([how] { return std::make_unique<Spoiled>(how); }, kDeterministic, kWorldsForFakes)
              .empty();
}

}  // namespace

TEST_CASE("every planner of the registry keeps the laws") {
  for (const PlannerEntry& entry : planners()) {
    const std::vector<std::string> broken =
        testing::broken_laws([&] { return entry.make({}); }, entry.guarantees, kWorlds);
    std::string first;
    for (std::size_t i = 0; i < std::min<std::size_t>(broken.size(), 10); ++i) first += "\n" + broken[i];
    INFO(entry.name << first);
    CHECK(broken.empty());
  }
}

TEST_CASE("planners that break the laws are caught") {
  CHECK(is_caught<Reckless>());
  CHECK(is_caught<Inexact>());
  CHECK(is_caught(Spoiled::How::forgets_the_reason));
  CHECK(is_caught(Spoiled::How::gives_up_early));
  CHECK(is_caught(Spoiled::How::remembers));
  CHECK(is_caught(Spoiled::How::prefers_left));
  CHECK(is_caught(Spoiled::How::marks_left));
  CHECK(is_caught<IgnoresBudget>());
  CHECK(is_caught<IgnoresTheAnswer>());
}

TEST_CASE("what a planner calls ok is checked before it is passed on") {
  const ObstacleField one({{5, 5}}, {disc({0, 0}, 0.5)});
  PlanRequest request;
  request.start = {-3, 0};
  request.goal = {3, 0};
  const Plan reckless = Reckless().plan(one, request);
  CHECK(reckless.status == PlanStatus::not_found);
  CHECK(reckless.path.empty());
  CHECK_THAT(reckless.reason, Catch::Contains("through an obstacle"));
  request.goal = {-3, 4};
  CHECK(Reckless().plan(one, request).status == PlanStatus::ok);
  CHECK_THAT(Inexact().plan(one, request).reason, Catch::Contains("end at the goal"));
}

}  // namespace regista
