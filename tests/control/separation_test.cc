// Motions and the distances between them against an oracle that halves time (tests/support/exact_motion.h): random
// motions, grazing ones, starts at the gap, rest and growth; and that braking is, one period later, the rest of itself.
#include "control/safety/separation.h"

#include <catch2/catch.hpp>

#include "planning/uniform.h"
#include "tests/support/exact_motion.h"
#include "tests/support/share.h"

namespace regista::testing {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kGraze_m = 1e-7;  ///< nearer to the gap than this, either answer would do
constexpr double kBraking_mps2 = 4.0;
constexpr double kPeriod_s = 0.01;

Vec2 any(std::mt19937_64& random, double length_max) {
  const double angle_rad = uniform(random, -std::numbers::pi, std::numbers::pi);
  return rotated({uniform(random, 0.0, length_max), 0.0}, angle_rad);
}

/// Standing, braking, or one period towards another velocity first, perhaps held for a while.
Motion random_motion(std::mt19937_64& random) {
  const Vec2 position_m = any(random, 2.0);
  const Vec2 velocity_mps = random() % 5 == 0 ? Vec2(Vec2::Zero()) : any(random, 3.0);
  const double hold_s = random() % 2 == 0 ? 0.0 : uniform(random, 0.0, 0.3);
  if (random() % 2 == 0) return braking(position_m, velocity_mps, hold_s, kBraking_mps2, kPeriod_s);
  const Vec2 next_mps = velocity_mps + any(random, 0.04);
  return manoeuvre(position_m, velocity_mps, next_mps, hold_s, kBraking_mps2, kPeriod_s);
}

Obstacle random_shape(std::mt19937_64& random) {
  const Vec2 a = any(random, 2.0);
  const Vec2 b = any(random, 2.0);
  const std::uint64_t core = random() % 3;
  return core == 0 ? disc(a, 0.0) : core == 1 ? capsule(a, b, 0.0) : rounded_rectangle(a, b, 0.0);
}

TEST_CASE("two motions keep apart exactly up to their least distance") {
  std::mt19937_64 random(61);
  int near = 0;
  for (int i = 0; i < share_of(5'000); ++i) {
    const Motion a = random_motion(random);
    const Motion b = random_motion(random);
    const double least_m = least_distance(a, b);
    if (least_m < 1e-3) continue;
    INFO("motions " << i << " of seed 61");
    CHECK(keep_apart(a, b, {least_m - kGraze_m}, kNever));
    CHECK_FALSE(keep_apart(a, b, {least_m + kGraze_m}, kNever));
    CHECK(keep_apart(b, a, {least_m - kGraze_m}, kNever));
    const double start_m = (a.phases()[0].position_m - b.phases()[0].position_m).norm();
    if (least_m > start_m - 1e-3) continue;
    ++near;
    // At the time of contact they are so near, and never before.
    const double gap_m = (least_m + start_m) / 2.0;
    const double contact_s = time_to_contact(a, b, {gap_m}, kNever);
    REQUIRE(contact_s < kNever);
    const auto distance_m = [&](double at_s) {
      const Phase& of_a = a.phase_at(at_s);
      const Phase& of_b = b.phase_at(at_s);
      return (position_after(of_a, at_s - of_a.begin_s) - position_after(of_b, at_s - of_b.begin_s)).norm();
    };
    CHECK(distance_m(contact_s) == Approx(gap_m).margin(1e-6));
    for (int k = 0; k < 20; ++k) CHECK(distance_m(contact_s * k / 20.0) >= gap_m - 1e-6);
  }
  CHECK(near > share_of(1'000));
}

TEST_CASE("at the gap already: apart when leaving, not when standing or approaching") {
  const Motion still({0.0, 0.0}, Vec2::Zero());
  for (const double velocity : {-1.0, 0.0, 1.0}) {
    const Motion other = braking({0.2, 0.0}, {velocity, 0.0}, 0.0, kBraking_mps2, kPeriod_s);
    CHECK_FALSE(keep_apart(other, still, {0.2}, kNever));
    CHECK(keep_apart(other, still, {0.2 - 1e-9}, kNever) == (velocity >= 0.0));
  }
}

TEST_CASE("a gap that grows is kept or not as dense samples say") {
  constexpr int kSamples = 2000;
  constexpr double kUntil_s = 0.8;
  std::mt19937_64 random(62);
  int kept = 0;
  for (int i = 0; i < share_of(3'000); ++i) {
    Motion a(any(random, 1.0), any(random, 3.0));
    a.then(any(random, 4.0), uniform(random, 0.05, 0.5));
    Motion b(any(random, 1.0), any(random, 3.0));
    b.then(any(random, 4.0), uniform(random, 0.05, 0.5));
    const Gap gap{uniform(random, 0.05, 0.3), uniform(random, 0.0, 1.0)};
    const auto at = [](const Motion& motion, double t) {
      const Phase& phase = t < motion.settled_s() ? motion.phases().front() : motion.phases().back();
      return position_after(phase, t - phase.begin_s);
    };
    double left_m = kNever;
    for (int k = 0; k <= kSamples; ++k) {
      const double t = kUntil_s * k / kSamples;
      left_m = std::min(left_m, (at(a, t) - at(b, t)).norm() - gap.distance_m - gap.growth_mps * t);
    }
    INFO("motions " << i << " of seed 62");
    const bool keeps = keep_apart(a, b, gap, kUntil_s);
    if (keeps) CHECK(left_m >= -kGraze_m);
    // Together slower than 2·(3 m/s + 4 m/s² · 0.5 s) + 1 m/s, which half a sample can change the distance by.
    if (!keeps) CHECK(left_m <= 11.0 * kUntil_s / kSamples / 2.0);
    kept += keeps ? 1 : 0;
  }
  CHECK(kept > share_of(500));
}

TEST_CASE("a motion keeps off a shape exactly up to its least distance from the core") {
  std::mt19937_64 random(63);
  for (int i = 0; i < share_of(3'000); ++i) {
    const Motion motion = random_motion(random);
    const Obstacle shape = random_shape(random);
    const double least_m = least_clearance(motion, shape);
    INFO("motion " << i << " of seed 63");
    if (least_m < 1e-3) {
      CHECK_FALSE(keeps_off(motion, shape, 2e-3));
      continue;
    }
    CHECK(keeps_off(motion, shape, least_m - kGraze_m));
    CHECK_FALSE(keeps_off(motion, shape, least_m + kGraze_m));
  }
}

TEST_CASE("a motion keeps inside exactly up to its furthest coordinates") {
  std::mt19937_64 random(64);
  for (int i = 0; i < share_of(3'000); ++i) {
    const Motion motion = random_motion(random);
    const Vec2 most_m = furthest(motion);
    INFO("motion " << i << " of seed 64");
    CHECK(keeps_inside(motion, most_m + Vec2::Constant(kGraze_m)));
    CHECK_FALSE(keeps_inside(motion, most_m + Vec2(-kGraze_m, kGraze_m)));
    CHECK_FALSE(keeps_inside(motion, most_m + Vec2(kGraze_m, -kGraze_m)));
  }
}

TEST_CASE("the box of a motion holds it") {
  std::mt19937_64 random(65);
  for (int i = 0; i < 1000; ++i) {
    const Motion motion = random_motion(random);
    for (const Phase& phase : motion.phases()) {
      const double length_s = &phase == &motion.phases().back() ? 0.0 : (&phase)[1].begin_s - phase.begin_s;
      for (int k = 0; k <= 20; ++k) {
        const Vec2 point = position_after(phase, length_s * k / 20);
        CHECK((point - motion.low_m()).minCoeff() >= -1e-12);
        CHECK((motion.high_m() - point).minCoeff() >= -1e-12);
      }
    }
  }
}

TEST_CASE("braking ends at rest within its limit, and after each period it is the rest of itself") {
  std::mt19937_64 random(66);
  for (int i = 0; i < 2000; ++i) {
    // Whole numbers of periods' braking, which rounding must not turn into one more, are among the speeds.
    const double speed = i % 2 == 0 ? uniform(random, 0.0, 3.0) : 0.04 * static_cast<double>(1 + random() % 75);
    Motion motion =
        braking(any(random, 2.0), rotated({speed, 0.0}, uniform(random, -3.0, 3.0)), 0.0, kBraking_mps2, kPeriod_s);
    const Vec2 end_m = motion.phases().back().position_m;
    const double periods = motion.settled_s() / kPeriod_s;
    CHECK(periods == Approx(std::round(periods)).margin(1e-9));
    CHECK(motion.settled_s() <= speed / kBraking_mps2 + kPeriod_s);
    double left_s = motion.settled_s();
    while (motion.settled_s() > 0.0 && left_s > kPeriod_s / 2.0) {
      const Phase& first = motion.phases().front();
      CHECK(first.acceleration_mps2.norm() <= kBraking_mps2 * (1.0 + 1e-5));
      motion =
          braking(position_after(first, kPeriod_s), velocity_after(first, kPeriod_s), 0.0, kBraking_mps2, kPeriod_s);
      left_s -= kPeriod_s;
      INFO("motion " << i << " of seed 66, " << left_s << " s left");
      CHECK((motion.phases().back().position_m - end_m).norm() <= 1e-9);
      if (left_s > kPeriod_s / 2.0) CHECK(motion.settled_s() == Approx(left_s).margin(1e-9));
    }
  }
}

}  // namespace
}  // namespace regista::testing
