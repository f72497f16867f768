// What is asked for among moving neighbours: times to contact against sampling, free wishes untouched, better choices
// than blocked wishes; opponents' accelerations from their velocities; the published search lowers hits.
#include "control/velocity_choice.h"

#include <catch2/catch.hpp>

#include "control/acceleration_estimate.h"
#include "control/safety/published_search.h"
#include "tests/control/ideal_team.h"

namespace regista {
namespace {

using test::Dice;
using test::robot_at;

constexpr double kNever = std::numeric_limits<double>::infinity();

TEST_CASE("the time to contact is when dense samples first touch") {
  constexpr double kStep_s = 2e-4;
  constexpr double kLasts_s = 0.3;
  Dice dice(81);
  int contacts = 0;
  for (int i = 0; i < 1000; ++i) {
    Neighbour other{dice.point(1, 1), dice.point(2, 2), i % 2 == 0 ? Vec2(Vec2::Zero()) : dice.point(3, 3), 0.2};
    const Vec2 velocity = dice.point(2, 2);
    if (other.position_m.norm() < 0.21) continue;
    const double contact_s = time_to_contact(Vec2::Zero(), velocity, other, kLasts_s);
    double sampled_s = kNever;
    for (double t = 0.0; t < 2.0 && sampled_s == kNever; t += kStep_s) {
      // The mean velocity while the acceleration lasts, the final one afterwards.
      const Vec2 driven =
          t * other.velocity_mps +
          (std::min(t, kLasts_s) * kLasts_s / 2.0 + std::max(0.0, t - kLasts_s) * kLasts_s) * other.acceleration_mps2;
      if ((other.position_m + driven - t * velocity).norm() < 0.2) sampled_s = t;
    }
    INFO("pair " << i << " of seed 81");
    if (sampled_s < kNever) CHECK(contact_s <= sampled_s + 1e-9);
    if (sampled_s < kNever) CHECK(contact_s >= sampled_s - 0.03);  // grazing chords are as long as that
    if (sampled_s == kNever && contact_s < 1.9) CHECK(contact_s >= 0.0);
    contacts += sampled_s < kNever ? 1 : 0;
  }
  CHECK(contacts > 100);
}

TEST_CASE("who overlaps is touched at once when approaching and never when leaving") {
  const Neighbour other{{0.1, 0.0}, Vec2::Zero(), Vec2::Zero(), 0.2};
  CHECK(time_to_contact(Vec2::Zero(), {1.0, 0.0}, other, 0.3) == 0.0);
  CHECK(std::isinf(time_to_contact(Vec2::Zero(), {-1.0, 0.0}, other, 0.3)));
}

TEST_CASE("a wish nobody is in the way of is kept; one that runs into somebody is not, and costs less") {
  Dice dice(82);
  const VelocityChoiceParams params{1.2, 0.6};
  int changed = 0;
  for (int i = 0; i < 500; ++i) {
    SafetyRobot robot;
    robot.velocity_mps = dice.point(2, 2);
    robot.wanted_mps = dice.direction() * dice.uniform(0.1, 3.0);
    std::vector<Neighbour> others;
    for (int k = 0; k < 4; ++k) others.push_back({dice.point(2, 2), dice.point(2, 2), Vec2::Zero(), 0.2});
    const auto cost = [&](const Vec2& velocity) {
      double soonest_s = params.horizon_s;
      for (const Neighbour& other : others) {
        soonest_s = std::min(soonest_s, time_to_contact(robot.position_m, velocity, other, 0.3));
      }
      const double danger = 1.0 / std::max(soonest_s, 0.01) - 1.0 / params.horizon_s;
      return (velocity - robot.wanted_mps).norm() + params.weight_m * danger;
    };
    const Vec2 chosen = choose_velocity(robot, kNever, others, params, 0.3);
    INFO("robot " << i << " of seed 82");
    CHECK(chosen == choose_velocity(robot, kNever, others, params, 0.3));
    if (cost(robot.wanted_mps) == 0.0) CHECK(chosen == robot.wanted_mps);
    CHECK(cost(chosen) <= cost(robot.wanted_mps));
    CHECK(cost(chosen) <= cost(Vec2::Zero()) + 1e-12);
    changed += chosen != robot.wanted_mps ? 1 : 0;
    // Whoever will stand before the contact is not in danger.
    CHECK(choose_velocity(robot, 0.0, others, params, 0.3) == robot.wanted_mps);
  }
  CHECK(changed > 20);
}

TEST_CASE("more is given up for a crash that would be our foul than for one that would be the other's") {
  SafetyRobot robot;
  robot.velocity_mps = {2.0, 0.0};
  robot.wanted_mps = {2.0, 0.0};
  const auto given_up = [&](const Vec2& theirs_mps, bool is_opponent, const Vec2& acceleration_mps2 = Vec2::Zero(),
                            const VelocityChoiceParams& params = {}) {
    // 0.3 s before the contact, whoever brings the speed.
    const Vec2 mean_mps = theirs_mps + 0.15 * acceleration_mps2;
    const Vec2 place{0.21 + 0.3 * (2.0 - mean_mps.x()), 0.05};
    const std::vector<Neighbour> other{{place, theirs_mps, acceleration_mps2, 0.21, is_opponent}};
    return (choose_velocity(robot, kNever, other, params, 0.3) - robot.wanted_mps).norm();
  };
  const Vec2 slower{-1.0, 0.0};
  CHECK(given_up(slower, true) > given_up(slower, false));
  CHECK(given_up(slower, true) > given_up({-2.4, 0.0}, true));  // it is the faster one
  CHECK(given_up({0.6, 0.0}, true) == 0.0);                     // 1.4 m/s is no crash
  const Vec2 as_fast{-2.1, 0.0};
  CHECK(given_up(as_fast, true) > given_up(as_fast, false));  // both are guilty
  // It is faster now, and slower than we are by then.
  CHECK(given_up({-2.4, 0.0}, true, {3.0, 0.0}) > given_up({-2.4, 0.0}, false, {3.0, 0.0}));
  // Without a horizon or a weight they cost nothing, and are left to the safety search.
  for (const auto& [horizon_s, weight_m] : {std::pair{0.0, 1.0}, std::pair{0.8, 0.0}}) {
    VelocityChoiceParams plain;
    plain.foul_horizon_s = horizon_s;
    plain.foul_weight_m = weight_m;
    CHECK(given_up(slower, true, Vec2::Zero(), plain) == 0.0);
  }
}

TEST_CASE("a foul with one that is seen late counts from so much further ahead") {
  SafetyRobot robot;
  robot.velocity_mps = {2.0, 0.0};
  robot.wanted_mps = {2.0, 0.0};
  std::vector<Neighbour> other{{{0.21 + 0.8 * 3.0, 0.05}, {-1.0, 0.0}, Vec2::Zero(), 0.21, true}};  // 0.8 s before
  VelocityChoiceParams params;
  REQUIRE(params.foul_horizon_s < 0.8);
  CHECK(choose_velocity(robot, kNever, other, params, 0.3) == robot.wanted_mps);
  other[0].late_s = 0.5;
  const Vec2 late = choose_velocity(robot, kNever, other, params, 0.3);
  CHECK(late != robot.wanted_mps);
  other[0].late_s = 0.0;
  params.foul_horizon_s += 0.5;
  CHECK(choose_velocity(robot, kNever, other, params, 0.3) == late);
}

TEST_CASE("a robot that sets out close beside another sets out, if not quite in the direction wished for") {
  SafetyRobot robot;
  robot.wanted_mps = {0.03, 0.004};  // one period's, a little towards the other
  const std::vector<Neighbour> beside{{{0.0, 0.2101}, Vec2::Zero(), Vec2::Zero(), 0.21}};
  const Vec2 chosen = choose_velocity(robot, kNever, beside, {}, 0.3);
  CHECK(chosen.x() > 0.02);
  CHECK(chosen.y() <= 0.0);
}

TEST_CASE("an acceleration is found from velocities, smoothed, bounded, and forgotten with its robot") {
  const RobotId id{Team::blue, 3};
  AccelerationEstimate estimate;
  WorldState world;
  for (int tick = 0; tick <= 100; ++tick) {
    world.robots = {robot_at(3, {0, 0}, 0.0, {{0.02 * tick, 0.0}, 0.0}, Team::blue),
                    robot_at(3, {1, 0}, 0.0, {{0.0, 0.5 * tick}, 0.0})};
    estimate.update(world, Team::blue, 0.01, 0.05, 4.0);
    if (tick == 0) CHECK(estimate.of(id) == Vec2(0.0, 0.0));
    if (tick == 1) CHECK((estimate.of(id).x() > 0.0 && estimate.of(id).x() < 1.0));
  }
  CHECK(estimate.of(id).x() == Approx(2.0).margin(1e-6));
  CHECK(estimate.of({Team::yellow, 3}) == Vec2(0.0, 0.0));
  world.robots[0].twist.velocity_mps.x() += 3.0;  // no robot does that
  estimate.update(world, Team::blue, 0.01, 0.05, 4.0);
  CHECK(estimate.of(id).norm() <= 4.0 + 1e-12);
  estimate.update(WorldState{}, Team::blue, 0.01, 0.05, 4.0);
  CHECK(estimate.of(id) == Vec2(0.0, 0.0));
}

TEST_CASE("the published search steers away from who stands ahead, and leaves a free robot alone") {
  const RobotLimits limits;
  SafetyParams params;
  params.team_margin_m = 0.02;  // 0.2 m between centres: who stands 5 mm within can still be passed
  SafetyRobot robot;
  robot.velocity_mps = {2.0, 0.0};
  robot.wanted_mps = {2.0, 0.0};
  const std::vector<SafetyRobot> team{robot};
  const std::vector<Opponent> far{{{3.0, 0.0}, Vec2::Zero(), Vec2::Zero()}};
  const std::vector<Opponent> ahead{{{0.62, 0.195}, Vec2::Zero(), Vec2::Zero()}};
  CHECK(published_choice(team, 0, far, limits, params, 0.01) == robot.wanted_mps);
  const Vec2 chosen = published_choice(team, 0, ahead, limits, params, 0.01);
  CHECK(chosen != robot.wanted_mps);
  CHECK(chosen.norm() <= robot.speed_max_mps);
  CHECK((chosen.x() < 2.0 || chosen.y() < 0.0));
}

}  // namespace
}  // namespace regista
