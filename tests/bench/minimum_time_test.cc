// The least time of the double integrator: it reaches rest, nothing faster does (the costate proves it), and where
// there is a formula it is that.
#include "modules/bench/motion/minimum_time.h"

#include <catch2/catch.hpp>
#include <random>

#include "modules/bench/motion/braking_time.h"
#include "planning/uniform.h"

namespace regista::bench {
namespace {

/// Where the control of the answer leads, in small steps.
std::pair<Vec2, Vec2> followed(const MinimumTime& answer, Vec2 x, Vec2 v, double a) {
  constexpr int kSteps = 20000;
  const double dt = answer.duration_s / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const double share = (i + 0.5) / kSteps;
    const Vec2 costate = answer.costate_begin + share * (answer.costate_end - answer.costate_begin);
    const Vec2 u = a * costate.normalized();
    x += v * dt + u * dt * dt / 2.0;
    v += u * dt;
  }
  return {x, v};
}

TEST_CASE("the answer comes to rest at the origin, and its costate proves that nothing faster does") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 300; ++i) {
    const double a = uniform(random, 1.0, 5.0);
    const Vec2 x = rotated({uniform(random, 0.0, 3.0), 0.0}, uniform(random, -3.0, 3.0));
    const Vec2 v = rotated({uniform(random, 0.0, 3.0), 0.0}, uniform(random, -3.0, 3.0));
    INFO("number " << i << ": x " << x.transpose() << ", v " << v.transpose() << ", a " << a);
    const MinimumTime answer = minimum_time(x, v, a);
    const auto [end, speed] = followed(answer, x, v, a);
    CHECK(end.norm() < 1e-3);
    CHECK(speed.norm() < 1e-3);
    CHECK(shortfall(answer, x, v, a, 0.999 * answer.duration_s) > 0.0);
    CHECK(shortfall(answer, x, v, a, 1.001 * answer.duration_s) < 0.0);
  }
}

TEST_CASE("states that are nearly on a line through the origin are found too") {
  std::mt19937_64 random(9);
  for (int i = 0; i < 300; ++i) {
    const double off_rad = std::pow(10.0, uniform(random, -8.0, -1.0));
    const Vec2 x = rotated({uniform(random, 0.0, 1.0), 0.0}, 0.7);
    const Vec2 v = rotated({uniform(random, -1.0, 1.0), 0.0}, 0.7 + off_rad);
    INFO("number " << i << ": x " << x.transpose() << ", v " << v.transpose());
    const MinimumTime answer = minimum_time(x, v, 3.0);
    CHECK(shortfall(answer, x, v, 3.0, 0.999 * answer.duration_s) > 0.0);
    CHECK(followed(answer, x, v, 3.0).first.norm() < 1e-3);
  }
}

TEST_CASE("along a line it is full ahead and full back") {
  CHECK(minimum_time({3.0, 0.0}, Vec2::Zero(), 3.0).duration_s == Approx(2.0).epsilon(1e-6));
  CHECK(minimum_time({-1.0, -1.0}, Vec2::Zero(), 4.0).duration_s ==
        Approx(2.0 * std::sqrt(std::sqrt(2.0) / 4.0)).epsilon(1e-6));
  // Just enough room to brake from 3 m/s.
  CHECK(minimum_time({-1.5, 0.0}, {3.0, 0.0}, 3.0).duration_s == Approx(1.0).epsilon(1e-6));
  // Away from the origin: brake 1.5 m further, then 3 m back as from rest.
  CHECK(minimum_time({0.0, 1.5}, {0.0, 3.0}, 3.0).duration_s == Approx(1.0 + 2.0).epsilon(1e-6));
  CHECK(minimum_time(Vec2::Zero(), Vec2::Zero(), 3.0).duration_s == 0.0);
}

TEST_CASE("turned and mirrored states take as long, a stronger robot less") {
  const Vec2 x(1.2, -0.4), v(0.5, 2.0);
  const double once = minimum_time(x, v, 3.0).duration_s;
  CHECK(minimum_time(rotated(x, 1.1), rotated(v, 1.1), 3.0).duration_s == Approx(once));
  CHECK(minimum_time({x.x(), -x.y()}, {v.x(), -v.y()}, 3.0).duration_s == Approx(once));
  CHECK(minimum_time(x, v, 4.0).duration_s < once);
  CHECK_THROWS_AS(minimum_time(x, v, 0.0), std::invalid_argument);
}

TEST_CASE("under the limits model the least time lies between those of both discs") {
  std::mt19937_64 random(11);
  int found = 0;
  for (int i = 0; i < 100; ++i) {
    const Vec2 x = rotated({uniform(random, 0.2, 3.0), 0.0}, uniform(random, -3.0, 3.0));
    const Vec2 v = rotated({uniform(random, 0.0, 3.0), 0.0}, uniform(random, -3.0, 3.0));
    INFO("number " << i << ": x " << x.transpose() << ", v " << v.transpose());
    const std::optional<double> time = braking_time(x, v, 3.0, 4.0);
    if (!time) continue;
    ++found;
    CHECK(*time <= minimum_time(x, v, 3.0).duration_s + 1e-4);
    CHECK(*time >= minimum_time(x, v, 4.0).duration_s - 1e-4);
    CHECK(*braking_time(x, v, 3.0, 3.0) == Approx(minimum_time(x, v, 3.0).duration_s).epsilon(1e-4));
  }
  CHECK(found > 80);
  // Nearly along a line: d = s²/2a + s²/2b in s/a + s/b.
  const std::optional<double> line = braking_time({-7.0 / 6.0, 0.0}, {0.0, 0.05}, 3.0, 4.0);
  REQUIRE(line.has_value());
  CHECK(*line == Approx(2.0 / 3.0 + 2.0 / 4.0).epsilon(1e-2));
}

}  // namespace
}  // namespace regista::bench
