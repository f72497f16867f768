// Obstacles where they will be met: the moment of nearest approach against sampling, uncovered ends, the rest
// untouched.
#include "planning/predicted_obstacles.h"

#include <catch2/catch.hpp>

#include "planning/clearance.h"
#include "planning/uniform.h"

namespace regista {
namespace {

Vec2 any(std::mt19937_64& random, double half) {
  const double x = uniform(random, -half, half);
  return {x, uniform(random, -half, half)};
}

RobotState random_robot(std::mt19937_64& random, std::uint16_t number) {
  RobotState robot;
  robot.id = {Team::yellow, number};
  robot.pose.position_m = any(random, 2.0);
  robot.twist.velocity_mps = any(random, 3.0);
  return robot;
}

TEST_CASE("no sampled moment within the horizon is nearer than the nearest approach") {
  std::mt19937_64 random(91);
  for (int i = 0; i < 1000; ++i) {
    const RobotState a = random_robot(random, 0);
    const RobotState b = random_robot(random, 1);
    const double horizon_s = uniform(random, 0.0, 2.0);
    const double nearest_s = nearest_approach_s(a, b, horizon_s);
    REQUIRE(nearest_s >= 0.0);
    REQUIRE(nearest_s <= horizon_s);
    const auto distance = [&](double t) {
      return (a.pose.position_m - b.pose.position_m + t * (a.twist.velocity_mps - b.twist.velocity_mps)).norm();
    };
    for (int k = 0; k <= 100; ++k) CHECK(distance(horizon_s * k / 100) >= distance(nearest_s) - 1e-9);
    CHECK(nearest_approach_s(b, a, horizon_s) == Approx(nearest_s).margin(1e-12));
  }
  RobotState still = random_robot(random, 0);
  CHECK(nearest_approach_s(still, still, 1.0) == 0.0);
}

constexpr double kSpeed_mps = 2.0;

TEST_CASE("others move to the approach and shrink off start and goal; oneself and what stands stay") {
  std::mt19937_64 random(92);
  int shrunk = 0;
  int after_arrival = 0;
  for (int i = 0; i < 1000; ++i) {
    WorldState world;
    std::vector<Obstacle> obstacles;
    for (std::uint16_t k = 0; k < 5; ++k) {
      world.robots.push_back(random_robot(random, k));
      obstacles.push_back(disc(world.robots.back().pose.position_m, 0.2));
    }
    world.robots.back().id.team = Team::blue;
    obstacles.push_back(rounded_rectangle({-5, -5}, {-4, 5}, 0.1));
    const RobotState& self = world.robots[2];
    const Vec2 goal = any(random, 2.0);
    const double horizon_s = i % 5 == 0 ? 0.0 : 1.5;
    const double team_horizon_s = i % 3 == 0 ? 0.0 : 1.0;
    std::vector<Obstacle> out;
    predict(obstacles, world, self, goal, {horizon_s, team_horizon_s, kSpeed_mps}, out);
    RobotState on_its_way = self;
    on_its_way.twist.velocity_mps = kSpeed_mps * (goal - self.pose.position_m).normalized();
    const double arrival_s = (goal - self.pose.position_m).norm() / kSpeed_mps;
    RobotState there = self;
    there.pose.position_m = goal;
    there.twist.velocity_mps = Vec2::Zero();
    REQUIRE(out.size() == obstacles.size());
    CHECK(out[2] == obstacles[2]);
    CHECK(out[5] == obstacles[5]);
    for (std::size_t k = 0; k < 5; ++k) {
      if (k == 2) continue;
      const RobotState& other = world.robots[k];
      INFO("world " << i << " of seed 92, robot " << k);
      const double ahead_s = k == 4 ? horizon_s : team_horizon_s;
      double approach_s = nearest_approach_s(on_its_way, other, ahead_s);
      // It does not drive on beyond its goal.
      if (approach_s >= arrival_s) approach_s = std::max(arrival_s, nearest_approach_s(there, other, ahead_s));
      after_arrival += approach_s >= arrival_s ? 1 : 0;
      const Vec2 expected = other.pose.position_m + approach_s * other.twist.velocity_mps;
      CHECK((out[k].a - expected).norm() <= 1e-12);
      CHECK(out[k].b == out[k].a);
      CHECK(out[k].radius_m <= obstacles[k].radius_m);
      CHECK(clearance(self.pose.position_m, out[k]) >= -1e-9);
      // A goal that somebody stands on stays covered: that is for the goal's adjustment to see.
      if (clearance(goal, obstacles[k]) >= 0.0) CHECK(clearance(goal, out[k]) >= -1e-9);
      shrunk += out[k].radius_m < obstacles[k].radius_m ? 1 : 0;
    }
  }
  CHECK(shrunk > 20);
  CHECK(after_arrival > 100);
}

}  // namespace
}  // namespace regista
