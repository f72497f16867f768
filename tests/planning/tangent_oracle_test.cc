// The judge is judged: against formulas, against its own mirror images, and against graphs that approach the truth from
// above.
#include "tests/support/tangent_oracle.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/support/planning_oracles.h"
#include "tests/support/planning_worlds.h"
#include "tests/support/varied_worlds.h"

namespace regista::testing {
namespace {

constexpr double kPi = std::numbers::pi;
const Bounds kWide{{10, 10}};

double length(const std::vector<Obstacle>& obstacles, const Vec2& start, const Vec2& goal,
              const Bounds& bounds = kWide) {
  return exact_shortest_length({bounds, obstacles}, start, goal).value_or(-1.0);
}

/// Around a disc of radius r from a point at distance a to the diametrically opposite one at distance b.
double around_disc(double r, double a, double b) {
  return std::sqrt(a * a - r * r) + std::sqrt(b * b - r * r) + r * (kPi - std::acos(r / a) - std::acos(r / b));
}

struct Case {
  ObstacleField field;
  PlanRequest request;
  std::optional<double> length_m;
};

/// The next random world whose start and goal are free.
Case next_case(std::mt19937_64& random, std::size_t obstacles_max) {
  for (;;) {
    Case out;
    out.field = varied_field(random, random() % (obstacles_max + 1));
    out.request = random_free_request(random, out.field);
    const PlanRequest& request = out.request;
    if (!point_is_free(out.field, request.start, request.ignored)) continue;
    if (!point_is_free(out.field, request.goal, request.ignored)) continue;
    out.length_m = exact_shortest_length(out.field, request.start, request.goal, request.ignored);
    return out;
  }
}

bool agree(const std::optional<double>& one, const std::optional<double>& other) {
  return one.has_value() == other.has_value() && (!one || std::abs(*one - *other) < 1e-9 * (1.0 + *one));
}

/// At most as long; no path at all is longer than any.
bool is_at_most(const std::optional<double>& one, const std::optional<double>& other) {
  return !other || (one && *one <= *other + 1e-9);
}

Vec2 quarter_turned(const Vec2& v) { return {-v.y(), v.x()}; }

ObstacleField quarter_turned(const ObstacleField& field) {
  std::vector<Obstacle> all;
  for (const Obstacle& o : field.obstacles()) {
    const Vec2 a = quarter_turned(o.a), b = quarter_turned(o.b);
    all.push_back(o.core == Core::rectangle ? rounded_rectangle(a, b, o.radius_m) : Obstacle{o.core, a, b, o.radius_m});
  }
  return {Bounds{{field.bounds().half_extent_m.y(), field.bounds().half_extent_m.x()}}, all};
}

/// The shortest path over the corners of regular n-gons around all rounded corners: longer than the truth.
std::optional<double> over_polygons(const Case& c, int n) {
  std::vector<Vec2> nodes{c.request.start, c.request.goal};
  for (const Obstacle& o : c.field.obstacles()) {
    for (const Vec2& corner : {o.a, o.b, Vec2(o.a.x(), o.b.y()), Vec2(o.b.x(), o.a.y())}) {
      if (o.core == Core::point && &corner != &o.a && nodes.back() == o.a) continue;
      for (int k = 0; k < n; ++k) {
        const Vec2 node = corner + rotated({o.radius_m / std::cos(kPi / n), 0.0}, 2.0 * kPi * (k + 0.5) / n);
        if (point_is_free(c.field, node, c.request.ignored)) nodes.push_back(node);
        if (o.radius_m == 0.0) break;
      }
      if (o.core == Core::point) break;
    }
  }
  return shortest_length(c.field, nodes, c.request.ignored);
}

}  // namespace

TEST_CASE("the exact length around one obstacle is the formula's") {
  CHECK(length({}, {-3, 1}, {1, 4}) == Approx(5.0).epsilon(1e-14));
  CHECK(length({disc({0, 0}, 1)}, {-3, 0}, {2, 0}) == Approx(around_disc(1, 3, 2)).epsilon(1e-14));
  CHECK(length({disc({0, 0}, 1)}, {-1, 0}, {0, 1}) == Approx(kPi / 2).epsilon(1e-9));
  CHECK(length({rounded_rectangle({-1, -1}, {1, 0.5}, 0)}, {-3, 0}, {3, 0}) ==
        Approx(2 * std::hypot(2.0, 0.5) + 2).epsilon(1e-14));
  const double to_end = std::sqrt(4 - 0.25) + 0.5 * (kPi / 2 - std::acos(0.25));
  CHECK(length({capsule({-1, 0}, {1, 0}, 0.5)}, {-3, 0}, {3, 0}) == Approx(2 * to_end + 2).epsilon(1e-14));
  // A rectangle without height, grown, is the same capsule.
  CHECK(length({rounded_rectangle({-1, 0}, {1, 0}, 0.5)}, {-3, 0}, {3, 0}) == Approx(2 * to_end + 2).epsilon(1e-14));
}

TEST_CASE("the exact length between two discs crosses from side to side") {
  // Above the left disc, below the right one: the half up to the origin, twice.
  const double first = std::atan2(0.5, -2.5) - std::acos(1 / std::sqrt(6.5));
  const double last = std::atan2(0.5, 1.5) + std::acos(1 / std::sqrt(2.5));
  const double expected = 2 * (std::sqrt(5.5) + (first - last) + std::sqrt(1.5));
  CHECK(length({disc({-1.5, -0.5}, 1), disc({1.5, 0.5}, 1)}, {-4, 0}, {4, 0}) == Approx(expected).epsilon(1e-14));
}

TEST_CASE("an arc goes all the way round, but not through what stands on it") {
  const auto at = [](double degrees) { return rotated({1, 0}, degrees * kPi / 180); };
  const auto around = [&](const std::vector<Obstacle>& more, double from_degrees, double to_degrees) {
    std::vector<Obstacle> all{disc({0, 0}, 1)};
    all.insert(all.end(), more.begin(), more.end());
    return length(all, at(from_degrees), at(to_degrees), Bounds{{3, 3}}) * 180 / kPi;
  };
  // What closes the short way is not where the two would meet halfway.
  CHECK(around({rounded_rectangle({0.5, -0.01}, {4, 0.01}, 0)}, 5, -15) == Approx(340).epsilon(1e-9));
  CHECK(around({disc({3, 0}, 2.05)}, 30, -80) == Approx(250).epsilon(1e-9));
  // Down through the lower bound, or up through a disc that reaches over the upper one.
  const Vec2 down(0, -0.5);
  CHECK(length({disc(down, 1), disc({0.7, 1}, 0.8)}, down + at(-29), down + at(87), Bounds{{3, 1}}) == -1.0);
}

TEST_CASE("touching is free and overlapping is not") {
  const auto around = [](double r) { return length({disc({0, 0}, r)}, {-2, 0}, {2, 0}, Bounds{{2, 1}}); };
  CHECK(around(1.0) == Approx(around_disc(1, 2, 2)).epsilon(1e-9));
  CHECK(around(1.0 + 1e-6) == -1.0);
  // Two discs that reach over the bounds: the only way is between them.
  const auto gate = [](double gap, const Vec2& start, const Vec2& goal) {
    return length({disc({0, 1 + gap / 2}, 1), disc({0, -1 - gap / 2}, 1)}, start, goal, Bounds{{3, 1.9}});
  };
  CHECK(gate(0.0, {-2, 0}, {2, 0}) == Approx(4.0).epsilon(1e-14));
  CHECK(gate(0.0, {-2, 1}, {2, 1}) == Approx(around_disc(1, 2, 2)).epsilon(1e-9));
  CHECK(gate(0.0, {-2, 1}, {2, -1}) == Approx(around_disc(1, 2, 2)).epsilon(1e-9));
  CHECK(gate(-1e-6, {-2, 0}, {2, 0}) == -1.0);
  CHECK(length({rounded_rectangle({-1, 0}, {1, 3}, 0), rounded_rectangle({-1, -3}, {1, 0}, 0)}, {-2, 0}, {2, 0},
               Bounds{{3, 2}}) == Approx(4.0).epsilon(1e-14));
}

TEST_CASE("the exact length does not depend on how one looks at the world") {
  std::mt19937_64 random(21);
  for (int world = 0; world < 500; ++world) {
    const Case c = next_case(random, 12);
    const auto& [field, request, expected] = c;
    INFO("world " << world << ": " << pasteable(field, request));
    REQUIRE(agree(exact_shortest_length(field, request.goal, request.start, request.ignored), expected));
    const ObstacleField turned = quarter_turned(field);
    REQUIRE(agree(
        exact_shortest_length(turned, quarter_turned(request.start), quarter_turned(request.goal), request.ignored),
        expected));
    for (const Vec2& signs : {Vec2(-1, 1), Vec2(1, -1)}) {
      const PlanRequest mirror = mirrored(request, signs);
      REQUIRE(
          agree(exact_shortest_length(mirrored(field, signs), mirror.start, mirror.goal, mirror.ignored), expected));
    }
  }
}

TEST_CASE("the exact length is no shorter than the straight line, and removing an obstacle never lengthens it") {
  std::mt19937_64 random(22);
  for (int world = 0; world < 500; ++world) {
    Case c = next_case(random, 12);
    c.request.ignored.clear();
    if (!point_is_free(c.field, c.request.start, {}) || !point_is_free(c.field, c.request.goal, {})) continue;
    const auto all = exact_shortest_length(c.field, c.request.start, c.request.goal);
    INFO("world " << world << ": " << pasteable(c.field, c.request));
    REQUIRE(all.value_or(1e9) >= (c.request.goal - c.request.start).norm() - 1e-12);
    for (std::size_t i = 0; i < c.field.size(); ++i) {
      REQUIRE(is_at_most(exact_shortest_length(c.field, c.request.start, c.request.goal, {{i}}), all));
    }
  }
}

TEST_CASE("graphs around ever finer polygons approach the exact length from above") {
  std::mt19937_64 random(23);
  int near = 0, reached = 0, bent = 0;
  for (int world = 0; world < 1000; ++world) {
    const Case c = next_case(random, 6);
    INFO("world " << world << ": " << pasteable(c.field, c.request));
    const std::optional<double> fine = over_polygons(c, 64);
    REQUIRE(is_at_most(c.length_m, over_polygons(c, 9)));
    REQUIRE(is_at_most(c.length_m, fine));
    if (!c.length_m) continue;
    ++reached;
    if (*c.length_m > (c.request.goal - c.request.start).norm() + 1e-6) ++bent;
    // Through a gap narrower than what polygons add to discs only the exact path leads.
    if (fine && *fine <= 1.001 * *c.length_m) ++near;
  }
  CAPTURE(near, reached, bent);
  CHECK(bent >= 150);
  CHECK(near >= reached * 99 / 100);
}

}  // namespace regista::testing
