#include "tests/support/planning_conformance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "planning/goal_adjustment.h"
#include "tests/support/planning_oracles.h"
#include "tests/support/planning_worlds.h"

namespace regista::testing {
namespace {

/// Enough for a random planner to cross a field of the test's size, few enough for thousands of worlds.
constexpr std::int64_t kIterations = 300;

/// How often a planner may ask for the time when it is up: one more than necessary is no harm.
constexpr int kQuestions = 2;

class Examination {
 public:
  Examination(const std::function<std::unique_ptr<Planner>()>& make, const Guarantees& guarantees)
      : make_(make), guarantees_(guarantees), planner_(make()) {}

  std::vector<std::string> run(int worlds) {
    simple_worlds();
    covered_ends();
    dead_ends();
    exact_contacts();
    crowd();
    budgets();
    nonsense();
    for (int seed = 0; seed < worlds; ++seed) random_world(seed);
    return broken_;
  }

 private:
  void expect(bool kept, const std::string& law) {
    if (!kept) broken_.push_back(law);
  }

  static PlanRequest request_of(const Vec2& start, const Vec2& goal) {
    PlanRequest request;
    request.start = start;
    request.goal = goal;
    return request;
  }

  static bool is_ok(const Plan& plan) { return plan.status == PlanStatus::ok; }

  /// A grid's steps go in eight directions, so only an optimal planner is held to the straight line itself.
  bool is_straight(const Plan& plan) const {
    const double straight_m = (plan.path.back() - plan.path.front()).norm();
    return plan.length_m <= straight_m * (guarantees_.optimal ? 1.0 + 1e-9 : 1.1);
  }

  /// Plans and checks whatever comes out against the laws that hold for every answer.
  Plan examine(const ObstacleField& field, const PlanRequest& request, const std::string& where) {
    Plan plan = planner_->plan(field, request);
    if (is_ok(plan)) {
      const std::string fault = fault_of(field, request, plan);
      expect(fault.empty(), where + ": the path " + fault);
      const double straight_m = (plan.path.back() - request.start).norm();
      expect(plan.length_m >= straight_m - 1e-9, where + ": shorter than the straight line");
    } else {
      expect(plan.status != PlanStatus::invalid, where + ": invalid is for requests that make no sense");
      expect(!plan.reason.empty(), where + ": no path and no reason");
      expect(plan.path.empty() || plan.path.front() == request.start, where + ": does not begin at the start");
    }
    return plan;
  }

  void simple_worlds() {
    const Bounds bounds = test_bounds();
    const ObstacleField empty(bounds, {});
    const Plan plan = examine(empty, request_of({-3, 1}, {4, -2}), "no obstacles");
    expect(is_ok(plan), "no obstacles: not ok");
    expect(is_ok(plan) && is_straight(plan), "no obstacles: not the straight line");
    const Plan still = examine(empty, request_of({1, 2}, {1, 2}), "start = goal");
    expect(is_ok(still) && still.path == std::vector<Vec2>{{1, 2}} && still.length_m == 0.0, "start = goal: moves");
    const ObstacleField one(bounds, {disc({0, 0}, 0.5)});
    const Plan round = examine(one, request_of({-3, 0}, {3, 0}), "one disc");
    expect(is_ok(round), "one disc: not ok");
    expect(round.length_m < 8.0, "one disc: a long way round");
    PlanRequest ignoring = request_of({-3, 0}, {3, 0});
    ignoring.ignored = {0};
    const Plan through = examine(one, ignoring, "the only disc ignored");
    expect(is_ok(through) && is_straight(through), "the only disc ignored: not the straight line");
    const ObstacleField wall(bounds, {rounded_rectangle({-0.1, -4.5}, {0.1, 2.5}, 0.1)});
    expect(is_ok(examine(wall, request_of({-2, -2}, {2, -2}), "a wall with a way round")), "a wall: not ok");
  }

  void covered_ends() {
    const ObstacleField field(test_bounds(), {disc({-3, 0}, 0.5), disc({3, 0}, 0.5)});
    const Plan plan = examine(field, request_of({-2.8, 0}, {2.8, 0.1}), "both ends covered");
    expect(is_ok(plan) && plan.start_moved && plan.goal_moved, "both ends covered: not ok and moved");
    if (is_ok(plan)) {
      expect((plan.path[1] - Vec2(-2.5, 0)).norm() < 1e-9, "both ends covered: not the shortest way out");
      expect(plan.path.back() == *nearest_free_point(field, {2.8, 0.1}), "both ends covered: not the nearest goal");
    }
    const Plan outside = examine(field, request_of({-7, 1}, {9, 1}), "both ends out of bounds");
    expect(is_ok(outside) && outside.start_moved && outside.goal_moved, "both ends out of bounds: not ok and moved");
    if (is_ok(outside)) {
      expect((outside.path.back() - Vec2(kHalfLength_m, 1)).norm() < 1e-9, "out of bounds: goal is not clamped in");
    }
  }

  void dead_ends() {
    const ObstacleField ring(test_bounds(), ring_around({3, 0}, 1.0));
    expect(!is_ok(examine(ring, request_of({-3, 0}, {3, 0}), "walled-in goal")), "walled-in goal: ok");
    expect(!is_ok(examine(ring, request_of({3, 0}, {-3, 0}), "walled-in start")), "walled-in start: ok");
    expect(is_ok(examine(ring, request_of({3, 0}, {3.2, 0.2}), "both walled in")), "both walled in: not ok");
    const ObstacleField full(test_bounds(), {disc({0, 0}, 50)});
    expect(examine(full, request_of({-3, 0}, {3, 0}), "no free point").status == PlanStatus::unreachable,
           "no free point: not unreachable");
  }

  /// Free space of no width between obstacles that touch, and legs along boundaries.
  void exact_contacts() {
    const ObstacleField gate(test_bounds(), {disc({0, 0.5}, 0.5), disc({0, -0.5}, 0.5)});
    expect(is_ok(examine(gate, request_of({-1, 0}, {1, 0}), "between two touching discs")), "touching discs: not ok");
    const ObstacleField floor(test_bounds(), {rounded_rectangle({-2, -1}, {2, 0}, 0.25), disc({0, 0.55}, 0.3)});
    examine(floor, request_of({-2, 0.25}, {2, 0.25}), "along a boundary");
    const ObstacleField same(test_bounds(), {disc({0, 0}, 0.5), disc({0, 0}, 0.5), disc({0, 0}, 0.25)});
    expect(is_ok(examine(same, request_of({-2, 0}, {2, 0}), "one disc three times")), "one disc three times: not ok");
  }

  void crowd() {
    std::mt19937_64 random(99);
    for (const std::size_t obstacles : {100U, 200U, 300U}) {
      const ObstacleField field = random_field(random, obstacles);
      examine(field, random_request(random, field), std::to_string(obstacles) + " overlapping obstacles");
    }
  }

  /// Walls with gaps at alternating ends and discs between them: no planner gets through without a search.
  static ObstacleField labyrinth() {
    std::vector<Obstacle> all;
    for (int wall = 0; wall < 5; ++wall) {
      const double x = 2.0 * wall - 4.0;
      const double gap = wall % 2 == 0 ? 0.8 : -0.8;
      all.push_back(rounded_rectangle({x - 0.1, -kHalfWidth_m + gap}, {x + 0.1, kHalfWidth_m + gap}, 0.1));
      for (const double y : {-2.4, -0.8, 0.8, 2.4}) all.push_back(disc({x + 1.0, y}, 0.3));
    }
    return {test_bounds(), all};
  }

  void spent_budgets() {
    const ObstacleField field = labyrinth();
    PlanRequest request = request_of({-5.5, 0}, {5.5, 0});
    // Anytime planners use all they get, and their nodes cost more the more there are.
    request.budget.iterations = guarantees_.anytime ? 30000 : 100000;
    expect(is_ok(examine(field, request, "labyrinth")), "labyrinth: not ok");
    PlanRequest unlucky = request;
    unlucky.budget.iterations = 0;
    // Planners whose answer is not a matter of luck draw nothing.
    if (!guarantees_.deterministic) {
      expect(!is_ok(examine(field, unlucky, "labyrinth, no iterations")), "labyrinth, no iterations: ok");
    }
    int questions = 0;
    const std::function<bool()> always = [&questions] { return ++questions > 0; };
    request.budget.out_of_time = &always;
    const Plan hurried = examine(field, request, "labyrinth, no time");
    expect(hurried.status == PlanStatus::not_found, "labyrinth, no time: not not_found");
    expect(questions > 0, "labyrinth, no time: the time is never asked for");
    expect(questions <= kQuestions, "labyrinth, no time: goes on when the time is up");
  }

  void budgets() {
    spent_budgets();
    const ObstacleField one(test_bounds(), {disc({0, 0}, 0.5)});
    PlanRequest request = request_of({-3, 0}, {3, 0});
    request.budget.iterations = 0;
    expect(examine(one, request, "no iterations").status != PlanStatus::unreachable, "no iterations: unreachable");
    const std::function<bool()> always = [] { return true; };
    request.budget.out_of_time = &always;
    expect(examine(one, request, "no time").status != PlanStatus::unreachable, "no time: unreachable");
  }

  void refuses(const PlanRequest& request, const std::string& what) {
    const ObstacleField one(test_bounds(), {disc({0, 0}, 0.5)});
    try {
      planner_->plan(one, request);
      expect(false, what + " is not refused");
    } catch (const std::invalid_argument&) {
    }
    graph::SharedGraph graph(one);
    const Plan plan = plan_or_invalid(*planner_, graph, request);
    expect(plan.status == PlanStatus::invalid && !plan.reason.empty(), what + " is not answered by invalid");
  }

  void nonsense() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    refuses(request_of({nan, 0}, {1, 0}), "a start that is not a number");
    refuses(request_of({0, 0}, {1, infinity}), "an infinite goal");
    PlanRequest request = request_of({-3, 0}, {3, 0});
    request.ignored = {1};
    refuses(request, "ignoring what does not exist");
    request.ignored = {0, 0};
    refuses(request, "an unsorted list");
    request.ignored.clear();
    request.budget.iterations = -1;
    refuses(request, "a negative budget");
  }

  void random_world(int seed) {
    const std::string where = "random world " + std::to_string(seed);
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    const ObstacleField field = random_field(random, static_cast<std::size_t>(seed % 45));
    PlanRequest request = random_request(random, field);
    request.budget.iterations = kIterations;
    const Plan plan = examine(field, request, where);
    expect(planner_->plan(field, request) == plan, where + ": asked twice, answered differently");
    expect(make_()->plan(field, request) == plan, where + ": a new planner answers differently");
    if (!guarantees_.deterministic) return;
    PlanRequest reseeded = request;
    reseeded.seed += 1;
    expect(planner_->plan(field, reseeded) == plan, where + ": says deterministic, depends on the seed");
    for (const Vec2& signs : {Vec2(-1, 1), Vec2(1, -1)}) {
      const Plan mirror = planner_->plan(mirrored(field, signs), mirrored(request, signs));
      expect(mirror.status == plan.status && std::abs(mirror.length_m - plan.length_m) < 1e-9 * (1 + plan.length_m),
             where + ": the mirrored world has another length");
      expect(!is_ok(plan) || are_mirrored(plan.path, mirror.path, signs),
             where + ": the mirrored world has another path");
    }
  }

  /// In random worlds no two ways are equally long.
  static bool are_mirrored(const std::vector<Vec2>& path, const std::vector<Vec2>& mirror, const Vec2& signs) {
    return std::equal(path.begin(), path.end(), mirror.begin(), mirror.end(),
                      [&](const Vec2& a, const Vec2& b) { return (a.cwiseProduct(signs) - b).norm() < 1e-9; });
  }

  const std::function<std::unique_ptr<Planner>()>& make_;
  Guarantees guarantees_;
  std::unique_ptr<Planner> planner_;
  std::vector<std::string> broken_;
};

}  // namespace

std::vector<std::string> broken_laws(const std::function<std::unique_ptr<Planner>()>& make,
                                     const Guarantees& guarantees, int worlds) {
  return Examination(make, guarantees).run(worlds);
}

}  // namespace regista::testing
