// Opponents at the moment that is planned for: against small steps of the same motion, and what the delay is made of.
#include "control/present_opponents.h"

#include <catch2/catch.hpp>
#include <random>

#include "planning/uniform.h"

namespace regista {
namespace {

Vec2 any(std::mt19937_64& random, double half) {
  const double x = uniform(random, -half, half);
  return {x, uniform(random, -half, half)};
}

}  // namespace

TEST_CASE("an acceleration goes on until the delay is over or what it takes away is gone") {
  std::mt19937_64 random(61);
  int stopped = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec2 place = any(random, 3.0);
    const Vec2 velocity = any(random, 2.0);
    const Vec2 acceleration = i % 3 == 0 ? Vec2(-uniform(random, 0.0, 8.0) * velocity.normalized()) : any(random, 8.0);
    const double delay_s = uniform(random, 0.0, 0.5);
    const double lasts_s = i % 2 == 0 ? delay_s : uniform(random, 0.0, delay_s);
    const Opponent then = accelerated(place + delay_s * velocity, velocity, acceleration, delay_s, lasts_s);
    constexpr int kSteps = 4000;
    const double step_s = delay_s / kSteps;
    Vec2 at = place;
    Vec2 moving = velocity;
    bool stands = false;
    for (int k = 0; k < kSteps; ++k) {
      // Who brakes does so until no speed is left along the way it went.
      if (k * step_s < lasts_s && !stands) moving += step_s * acceleration;
      stands = stands || (acceleration.dot(velocity) < 0.0 && moving.dot(velocity) <= 0.0);
      if (!stands) at += step_s * moving;
    }
    if (stands) moving = Vec2::Zero();
    stopped += stands ? 1 : 0;
    INFO("motion " << i << " of seed 61");
    CHECK((then.velocity_mps - moving).norm() <= 5e-3);
    CHECK(then.acceleration_mps2 == (stands ? Vec2(Vec2::Zero()) : acceleration));
    // A turn that also brakes is taken to end on the line it began on.
    const bool is_straight = std::abs(acceleration.normalized().dot(velocity.normalized())) > 0.999;
    if (!stands || is_straight) CHECK((then.position_m - at).norm() <= 5e-3);
  }
  CHECK(stopped > 50);
}

TEST_CASE("what goes straight and steady is where it coasts to, whatever the delay") {
  const Opponent then = accelerated({1.0, 2.0}, {3.0, 0.0}, Vec2::Zero(), 0.3, 0.3);
  CHECK(then.position_m == Vec2(1.0, 2.0));
  CHECK(then.velocity_mps == Vec2(3.0, 0.0));
}

TEST_CASE("the delay reaches from capture to when commands act, and over our drives' lag") {
  WorldState world;
  world.captured = Time{} + from_seconds(1.0);
  world.valid_at = Time{} + from_seconds(1.05);
  CHECK(planning_delay_s(world, 0.03) == Approx(0.08));
  world.valid_at = Time{} + from_seconds(9.0);
  CHECK(planning_delay_s(world, 0.03) == kLongestDelay_s);
  world.valid_at = Time{};  // of a state that nobody predicted
  CHECK(planning_delay_s(world, 0.03) == Approx(0.03));
}

TEST_CASE("an opponent that speeds up is seen faster than it was, one of ours is none") {
  ControlParams params;
  params.drive_lag_s = 0.03;
  PresentOpponents opponents;
  WorldState world;
  world.robots.resize(2);
  world.robots[0].id = {Team::yellow, 1};
  world.robots[1].id = {Team::blue, 4};
  std::span<const Opponent> seen;
  double way_m = 0.0;
  for (int tick = 0; tick < 100; ++tick) {
    const double speed_mps = 2.0 * tick * 0.01;  // 2 m/s²
    way_m += 0.01 * speed_mps;
    world.captured = Time{} + from_seconds(0.01 * tick);
    world.valid_at = world.captured + from_seconds(0.03);
    world.robots[1].pose.position_m = {way_m, 0.0};
    world.robots[1].twist.velocity_mps = {speed_mps, 0.0};
    seen = opponents.update(world, Team::blue, params, 0.01);
  }
  REQUIRE(seen.size() == 1);
  CHECK(seen[0].acceleration_mps2.x() == Approx(2.0).margin(0.01));
  CHECK(seen[0].velocity_mps.x() == Approx(1.98 + 2.0 * 0.06).margin(0.01));
  CHECK(seen[0].position_m.x() == Approx(way_m + 0.03 * 1.98 + 2.0 * 0.06 * 0.06 / 2.0).margin(0.001));
}

TEST_CASE("an acceleration is carried on for 60 ms, however late an opponent is seen") {
  ControlParams params;
  params.drive_lag_s = 0.03;
  PresentOpponents opponents;
  WorldState world;
  world.robots.resize(1);
  world.robots[0].id = {Team::blue, 4};
  double ahead_mps = 0.0;
  for (int tick = 0; tick < 100; ++tick) {
    const double speed_mps = 2.0 * tick * 0.01;  // 2 m/s²
    world.captured = Time{} + from_seconds(0.01 * tick);
    world.valid_at = world.captured + from_seconds(0.2);
    world.robots[0].twist.velocity_mps = {speed_mps, 0.0};
    ahead_mps = opponents.update(world, Team::blue, params, 0.01)[0].velocity_mps.x() - speed_mps;
  }
  CHECK(ahead_mps == Approx(2.0 * 0.06).margin(1e-6));
}

}  // namespace regista
