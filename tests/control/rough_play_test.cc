// Opponents that run into us are noticed, each contact once, and forgiven; among them no crash is ours.
#include "control/safety/rough_play.h"

#include <catch2/catch.hpp>
#include <numbers>

#include "control/safety/careful_approach.h"
#include "tests/control/ideal_team.h"
#include "world_model/types/crash_rule.h"

namespace regista {
namespace {

using test::Dice;
using test::robot_at;

constexpr double kPeriod_s = 0.01;
constexpr double kRadius_m = 0.09;

WorldState two(double apart_m, Team second) {
  WorldState world;
  world.robots = {robot_at(1, Vec2::Zero()), robot_at(2, {apart_m, 0.0}, 0.0, {}, second)};
  return world;
}

TEST_CASE("a contact counts once however long it lasts, again after bodies were apart, and is forgotten") {
  RoughPlay play;
  RoughPlayParams params;
  params.contacts = 1.5;
  const auto see = [&](double gap_m, Team second, int periods) {
    for (int i = 0; i < periods; ++i) {
      play.update(two(2.0 * kRadius_m + gap_m, second), Team::yellow, kPeriod_s, kRadius_m, params);
    }
  };
  see(0.01, Team::blue, 10);   // near is no contact
  see(0.0, Team::yellow, 10);  // nor are team-mates
  CHECK(play.contacts() == 0.0);
  see(0.0, Team::blue, 100);
  CHECK(play.contacts() == Approx(1.0).margin(0.05));
  see(0.02, Team::blue, 10);  // trembling at it
  see(0.0, Team::blue, 10);
  CHECK(play.contacts() == Approx(1.0).margin(0.05));
  CHECK_FALSE(play.is_rough(params));
  see(0.2, Team::blue, 10);
  see(0.0, Team::blue, 1);
  CHECK(play.is_rough(params));
  const double before = play.contacts();
  see(0.2, Team::blue, static_cast<int>(params.memory_s / kPeriod_s));
  CHECK(play.contacts() == Approx(before / std::numbers::e).epsilon(1e-6));
  params.contacts = 0.0;
  CHECK(RoughPlay().is_rough(params));
}

TEST_CASE("who approaches blamelessly and then brakes is never to blame, if the opponent gains no more than foreseen") {
  Dice dice(61);
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    double gap_m = dice.uniform(0.0, 2.0);
    double theirs_mps = dice.uniform(-1.0, 3.0);
    const double most_mps = theirs_mps + 0.5;
    double ours_mps = blameless_approach(gap_m, theirs_mps, 2.7);
    const double at_once_mps = ours_mps;
    CHECK(ours_mps >= kBlamelessSpeed_mps - 1e-9);
    CHECK(blameless_approach(gap_m + 0.1, theirs_mps, 2.7) > ours_mps);
    for (int step = 0; step < 4000 && gap_m > 0.0; ++step) {
      gap_m -= 0.001 * (ours_mps + theirs_mps);
      ours_mps = std::max(0.0, ours_mps - 0.001 * 2.7);
      theirs_mps = std::min(most_mps, theirs_mps + 0.003);
    }
    if (gap_m > 0.0) continue;
    ++met;
    INFO("approach " << i << " of seed 61, begun with " << at_once_mps << " m/s");
    const Fault fault = crash_fault(ours_mps - 0.01, theirs_mps);  // steps of a millisecond are off by that
    CHECK((fault == Fault::none || fault == Fault::second));
  }
  CHECK(met > 1000);
}

TEST_CASE("only speed towards opponents is taken away, and only near them") {
  const Vec2 wanted(2.5, 0.0);
  const auto careful = [&](std::vector<Opponent> opponents) {
    return careful_approach(wanted, Vec2::Zero(), opponents, 0.2, 2.7);
  };
  CHECK(careful({}) == wanted);
  CHECK(careful({{{-0.5, 0.0}, {3.0, 0.0}, Vec2::Zero()}}) == wanted);
  CHECK(careful({{{0.0, 0.5}, {0.0, -1.0}, Vec2::Zero()}}) == wanted);
  CHECK(careful({{{3.5, 0.0}, {-3.0, 0.0}, Vec2::Zero()}}) == wanted);
  CHECK(careful({{Vec2::Zero(), Vec2::Zero(), Vec2::Zero()}}) == wanted);
  const Vec2 slower = careful({{{0.8, 0.3}, {-1.0, 0.0}, Vec2::Zero()}});
  const Vec2 n = Vec2(0.8, 0.3).normalized();
  CHECK(slower.dot(n) < wanted.dot(n) - 0.5);
  CHECK((slower - wanted).dot(Vec2(-n.y(), n.x())) == Approx(0.0).margin(1e-12));
}

}  // namespace
}  // namespace regista
