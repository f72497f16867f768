// The exact planner against the judge in tests/support/tangent_oracle.h: same
// reachability, same length, free paths.
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>
#include <numbers>

#include "planning/graph/tangent_search.h"
#include "planning/registry.h"
#include "planning/uniform.h"
#include "tests/support/planning_oracles.h"
#include "tests/support/planning_worlds.h"
#include "tests/support/share.h"
#include "tests/support/tangent_oracle.h"
#include "tests/support/varied_worlds.h"

namespace regista::testing {
namespace {

constexpr double kRelative = 1e-6;
constexpr double kPolylineExcess = 1e-3;  // a circumscribed polyline may be so much longer than its arcs

/// One world after the other through search, planner and judge.
class Court {
 public:
  /// What is wrong with the planner's answers, with a query to paste; empty
  /// when nothing is. Worlds whose start or goal is covered are not looked at.
  std::string fault(const ObstacleField& field, const PlanRequest& request) {
    if (!point_is_free(field, request.start, request.ignored)) return "";
    if (!point_is_free(field, request.goal, request.ignored)) return "";
    expected_m_ = exact_shortest_length(field, request.start, request.goal, request.ignored);
    ++worlds_;
    if (!expected_m_) {
      ++unreachable_;
    } else if (*expected_m_ > (request.goal - request.start).norm() * (1.0 + kRelative)) {
      ++bent_;
    }
    graph_.reset(field);
    std::string wrong;
    if (request.start != request.goal) wrong = fault_of_search(request);
    if (wrong.empty()) wrong = fault_of_plan(request);
    if (wrong.empty()) return "";
    std::cerr << pasteable(field, request) << std::endl;
    return wrong + "; expected " + text(expected_m_) + ", found " + std::to_string(search_.length_m()) + " m";
  }

  std::string fault(const ObstacleField& field, const Vec2& start, const Vec2& goal) {
    PlanRequest request;
    request.start = start;
    request.goal = goal;
    return fault(field, request);
  }

  int worlds() const { return worlds_; }
  int bent() const { return bent_; }
  int unreachable() const { return unreachable_; }
  int known_free() const { return known_free_; }

 private:
  static std::string text(const std::optional<double>& length_m) {
    return length_m ? std::to_string(*length_m) + " m" : "no way";
  }

  std::string fault_of_search(const PlanRequest& request) {
    using End = graph::TangentSearch::End;
    const Query query{request.start, request.goal, request.ignored, request.seed, request.budget, {}};
    const End end = search_.find(graph_, query, path_);
    if (end == End::no_time) return "the search stops for a time that nobody limited";
    if ((end == End::goal) != expected_m_.has_value()) return "the search is wrong about reachability";
    if (end != End::goal) return "";
    if (path_.front() != request.start || path_.back() != request.goal) return "the search's path has other ends";
    if (!(std::abs(search_.length_m() - *expected_m_) <= kRelative * *expected_m_)) return "not the exact length";
    if (!search_.is_path_known_free()) return "";
    ++known_free_;
    if (!graph_.field().is_free(path_, request.ignored)) return "the path that the search knows to be free is not";
    return "";
  }

  std::string fault_of_plan(const PlanRequest& request) {
    const Plan plan = planner_->plan(graph_, request);
    if (plan.status != (expected_m_ ? PlanStatus::ok : PlanStatus::unreachable)) {
      return std::string("the plan is ") + name(plan.status) + ": " + plan.reason;
    }
    if (!expected_m_) return "";
    const std::string wrong = fault_of(graph_.field(), request, plan);
    if (!wrong.empty()) return "the plan " + wrong;
    if (!(plan.length_m >= *expected_m_ * (1.0 - kRelative))) return "the plan is shorter than the shortest path";
    if (!(plan.length_m <= *expected_m_ * (1.0 + kPolylineExcess))) return "the plan's polyline is too long";
    if (request.start == request.goal) return "";
    if (!(plan.length_m >= search_.length_m() - 1e-12)) return "the polyline is shorter than its arcs";
    return "";
  }

  std::unique_ptr<Planner> planner_ = make_planner("tangent");
  graph::TangentSearch search_;
  graph::SharedGraph graph_;
  std::vector<Vec2> path_;
  std::optional<double> expected_m_;
  int worlds_ = 0, bent_ = 0, unreachable_ = 0, known_free_ = 0;
};

std::mt19937_64 generator(int world) { return std::mt19937_64(static_cast<std::uint64_t>(world)); }

/// A point on the obstacle's boundary, up to rounding, or within the obstacle.
Vec2 on_boundary(std::mt19937_64& random, const Obstacle& obstacle) {
  const Vec2 corner = uniform(random) < 0.5 ? obstacle.a : obstacle.b;
  const int quarters = static_cast<int>(random() % 4);
  const double angle = uniform(random) < 0.5 ? quarters * std::numbers::pi / 2 : uniform(random, -3.0, 3.0);
  return corner + rotated({obstacle.radius_m, 0.0}, angle);
}

/// Discs, rectangles without radius and capsules on a grid, so that they touch
/// exactly, share sides and corners, and stand in line.
ObstacleField grid_field(std::mt19937_64& random) {
  std::vector<Obstacle> all;
  const double filled = uniform(random, 0.1, 0.6);
  for (int x = -3; x < 3; ++x) {
    for (int y = -2; y < 2; ++y) {
      if (uniform(random) > filled) continue;
      const Vec2 low(x, y), middle(x + 0.5, y + 0.5);
      const double kind = uniform(random);
      if (kind < 0.4) all.push_back(disc(middle, kind < 0.1 ? 0.5625 : 0.5));
      if (kind >= 0.4 && kind < 0.7) all.push_back(rounded_rectangle(low, low + Vec2(1, 1), 0.0));
      if (kind >= 0.7 && kind < 0.8) all.push_back(rounded_rectangle(low + Vec2(.25, .25), low + Vec2(.75, .75), 0.25));
      if (kind >= 0.8 && kind < 0.9) all.push_back(capsule(middle, middle + Vec2(1, 0), 0.5));
      if (kind >= 0.9) all.push_back(capsule(middle, middle + Vec2(0, 1), 0.25));
    }
  }
  return {Bounds{{3, 2}}, all};
}

Vec2 grid_point(std::mt19937_64& random) {
  const auto step = [&](int half) {
    return 0.5 * (static_cast<double>(random() % static_cast<unsigned>(4 * half + 1)));
  };
  const double x = step(3);
  return {x - 3.0, step(2) - 2.0};
}

/// A row of discs from bound to bound, each touching the next: the only ways
/// through have no width.
ObstacleField touching_row(std::mt19937_64& random) {
  std::vector<Obstacle> all;
  double y = -2.0;
  double x = 0.0;
  double radius = 0.0;
  while (y < 2.0) {
    const double next = uniform(random, 0.2, 0.8);
    const double lean = uniform(random, -0.5, 0.5);
    if (!all.empty()) {
      x += (radius + next) * std::sin(lean);
      y += (radius + next) * std::cos(lean);
    }
    all.push_back(disc({x, y}, next));
    radius = next;
  }
  return {Bounds{{5, 2}}, all};
}

}  // namespace

TEST_CASE("in varied worlds tangent agrees with the judge") {
  Court court;
  for (int world = 0; world < share_of(10000); ++world) {
    std::mt19937_64 random = generator(world);
    const ObstacleField field = varied_field(random, random() % (world % 4 == 0 ? 26 : 11));
    CAPTURE(world);
    REQUIRE(court.fault(field, random_free_request(random, field)) == "");
  }
  CAPTURE(court.worlds(), court.bent(), court.unreachable());
  CHECK(court.worlds() > share_of(9900));
  CHECK(court.bent() > share_of(2500));
  CHECK(court.unreachable() > share_of(200));
  CHECK(court.known_free() > share_of(5000));
}

TEST_CASE("on fields of a match's size tangent agrees with the judge") {
  Court court;
  for (int world = 0; world < share_of(1000); ++world) {
    std::mt19937_64 random = generator(world);
    const ObstacleField field = random_field(random, static_cast<std::size_t>(world % 50));
    CAPTURE(world);
    REQUIRE(court.fault(field, random_free_request(random, field)) == "");
  }
  CHECK(court.bent() > share_of(400));
}

TEST_CASE("with start and goal on boundaries tangent agrees with the judge") {
  Court court;
  for (int world = 0; world < share_of(10000); ++world) {
    std::mt19937_64 random = generator(world);
    const ObstacleField field = varied_field(random, 1 + random() % 6);
    PlanRequest request = random_free_request(random, field);
    request.start = on_boundary(random, field.obstacles()[random() % field.size()]);
    if (world % 3 != 0) request.goal = on_boundary(random, field.obstacles()[random() % field.size()]);
    CAPTURE(world);
    REQUIRE(court.fault(field, request) == "");
  }
  CHECK(court.worlds() > share_of(4000));
  CHECK(court.bent() > share_of(2500));
}

TEST_CASE("on a grid of obstacles that touch exactly tangent agrees with the judge") {
  Court court;
  for (int world = 0; world < share_of(10000); ++world) {
    std::mt19937_64 random = generator(world);
    const ObstacleField field = grid_field(random);
    const Vec2 start = grid_point(random);
    CAPTURE(world);
    REQUIRE(court.fault(field, start, grid_point(random)) == "");
  }
  CHECK(court.worlds() > share_of(7000));
  CHECK(court.bent() > share_of(4000));
}

TEST_CASE("through gates of no width tangent agrees with the judge") {
  Court court;
  for (int world = 0; world < share_of(1000); ++world) {
    std::mt19937_64 random = generator(world);
    const ObstacleField field = touching_row(random);
    const Vec2 start(-4.5, uniform(random, -2.0, 2.0));
    CAPTURE(world);
    REQUIRE(court.fault(field, start, {4.5, uniform(random, -2.0, 2.0)}) == "");
  }
  CHECK(court.bent() > share_of(900));
}

TEST_CASE("in special worlds tangent agrees with the judge") {
  const Bounds wide{{5, 5}};
  const Bounds corridor{{5, 1}};
  Court court;
  const auto check = [&](const Bounds& bounds, const std::vector<Obstacle>& obstacles, const Vec2& start,
                         const Vec2& goal) {
    const ObstacleField field(bounds, obstacles);
    CHECK(court.fault(field, start, goal) == "");
    CHECK(court.fault(field, goal, start) == "");
  };
  const Vec2 left(-3, 0), right(3, 0);
  SECTION("nothing, and nowhere to go") {
    check(wide, {}, left, right);
    check(wide, {disc({0, 0}, 1)}, left, left);
    check(Bounds{{0, 0}}, {}, {0, 0}, {0, 0});
    check(Bounds{{5, 0}}, {}, left, right);
    check(Bounds{{5, 0}}, {disc({0, 0}, 0.1)}, left, right);
  }
  SECTION("symmetric: both ways are equally long") {
    check(wide, {disc({0, 0}, 1)}, left, right);
    check(wide, {rounded_rectangle({-1, -1}, {1, 1}, 0.5), disc({2, 0}, 0.2)}, left, right);
  }
  SECTION("obstacles that touch the bounds") {
    check(corridor, {disc({0, 0}, 1)}, left, right);
    check(corridor, {disc({0, 0}, 1.001)}, left, right);
    check(corridor, {rounded_rectangle({-0.5, -1}, {0.5, 0.75}, 0.25)}, left, right);
    check(corridor, {rounded_rectangle({-0.5, -1}, {0.5, 1}, 0.0)}, left, right);
    check(corridor, {rounded_rectangle({-0.5, -2}, {0.5, 2}, 0.0)}, left, right);
    check(corridor, {disc({0, 0}, 0.5), disc({0, 0.75}, 0.25), disc({0, -0.75}, 0.25)}, left, right);
  }
  SECTION("identical obstacles and obstacles within obstacles") {
    check(wide, {disc({0, 0}, 1), disc({0, 0}, 1), disc({0, 0}, 1)}, left, right);
    check(wide, {disc({0, 0}, 1), disc({0.25, 0}, 0.75), disc({0, 0}, 0.5)}, left, right);
    check(wide, {rounded_rectangle({-1, -1}, {1, 1}, 0), disc({0, 0}, 1), disc({0.5, 0.5}, 0.25)}, left, right);
    check(wide, {capsule({-1, 0}, {1, 0}, 1), rounded_rectangle({-1, 0}, {1, 0}, 1)}, left, right);
    check(wide, {capsule({0, 0}, {0, 0}, 1), rounded_rectangle({0, 0}, {0, 0}, 1)}, left, right);
  }
  SECTION("without radius") {
    check(wide, {capsule({0, -1}, {0, 1}, 0), disc({1, 0}, 0)}, left, right);
    check(wide, {rounded_rectangle({0, -1}, {0, 1}, 0)}, left, right);
    check(wide, {rounded_rectangle({-1, -1}, {1, 1}, 0)}, left, right);
    check(wide, {rounded_rectangle({-1, -1}, {0, 1}, 0), rounded_rectangle({0, -1}, {1, 1}, 0)}, left, right);
    check(wide, {rounded_rectangle({-1, -1}, {1, 1}, 0)}, {-1, -1}, {1, 1});
    check(wide, {rounded_rectangle({-1, -1}, {1, 1}, 0)}, {-1, 0}, {1, 0});
    check(wide, {rounded_rectangle({-1, -1}, {1, 1}, 0)}, {-2, 1}, {2, 1});
  }
  SECTION("along boundaries") {
    check(wide, {disc({0, 0}, 1)}, {-1, 0}, {1, 0});
    check(wide, {disc({0, 0}, 1)}, {0, -1}, {0, 1});
    // Twice half way round and the sides; the short way is closed.
    check(wide, {disc({-1.5, 0}, 0.75), capsule({0, 0}, {1, 0}, 1)}, {0, 1}, {0, -1});
    // The capsule closes a side from corner to corner.
    check(wide, {capsule({-1, 0.5}, {1, 0.5}, 0.5), rounded_rectangle({0, 0}, {3, 1}, 0)}, {0, -1}, {-0.5, 2});
    check(wide, {capsule({-1, 0.5}, {1, 0.5}, 0.5), rounded_rectangle({0, 0}, {3, 1}, 0)}, {0, 0}, {0, 1});
  }
  SECTION("walled in, and out of a hook") {
    check(wide, ring_around({3, 0}, 1.0), left, right);
    check(wide, ring_around({3, 0}, 1.0), {3.1, 0}, {2.9, 0.1});
    check(Bounds{{3, 3}}, {disc({0, 0}, 1), rounded_rectangle({0.5, -0.01}, {4, 0.01}, 0)}, {2, 0.5}, {2, -0.5});
    check(wide, {capsule({-1, -1}, {1, -1}, 0.1), capsule({-1, 1}, {1, 1}, 0.1), capsule({1, -1}, {1, 1}, 0.1)}, {0, 0},
          {3, 0});
  }
}

TEST_CASE("among hundreds of overlapping obstacles tangent agrees with the judge") {
  Court court;
  for (int world = 0; world < 16; ++world) {
    std::mt19937_64 random = generator(world);
    const ObstacleField field = random_field(random, world < 12 ? 200 : 400);
    CAPTURE(world);
    REQUIRE(court.fault(field, random_free_request(random, field)) == "");
  }
  CHECK(court.bent() > 5);
}

}  // namespace regista::testing
