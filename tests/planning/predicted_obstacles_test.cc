// Obstacles where they will be met: the moment of nearest approach against sampling, uncovered ends, the rest
// untouched.
#include "planning/predicted_obstacles.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "planning/clearance.h"
#include "planning/uniform.h"

namespace regista {
namespace {

constexpr double kForEver_s = std::numeric_limits<double>::infinity();

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

Course random_course(std::mt19937_64& random) {
  const RobotState robot = random_robot(random, 0);
  const double lasts_s = uniform(random, 0.0, 3.0);
  return {robot.pose.position_m, robot.twist.velocity_mps, lasts_s < 2.0 ? lasts_s : kForEver_s};
}

TEST_CASE("no sampled moment within the horizon is nearer than the nearest approach") {
  std::mt19937_64 random(91);
  for (int i = 0; i < 1000; ++i) {
    const Course a = random_course(random);
    const Course b = random_course(random);
    const double horizon_s = uniform(random, 0.0, 2.0);
    const double nearest_s = nearest_approach_s(a, b, horizon_s);
    INFO("pair " << i << " of seed 91");
    REQUIRE(nearest_s >= 0.0);
    REQUIRE(nearest_s <= horizon_s + 1e-12);
    const auto distance = [&](double t) { return (a.at(t) - b.at(t)).norm(); };
    for (int k = 0; k <= 100; ++k) CHECK(distance(horizon_s * k / 100) >= distance(nearest_s) - 1e-9);
    CHECK(nearest_approach_s(b, a, horizon_s) == Approx(nearest_s).margin(1e-9));
  }
  const Course still = {{1.0, 2.0}, Vec2::Zero(), kForEver_s};
  CHECK(nearest_approach_s(still, still, 1.0) == 0.0);
}

TEST_CASE("who stands at its goal is not expected beyond it, and who sets out not to take for ever") {
  RobotState robot;
  robot.twist.velocity_mps = {2.0, 0.0};
  CHECK(arrival_s(robot, {3.0, 0.0}, 1.5) == Approx(1.5));
  robot.twist.velocity_mps = Vec2::Zero();
  CHECK(arrival_s(robot, {3.0, 0.0}, 1.5) == Approx(2.0));
  const Course course{{0.0, 0.0}, {2.0, 0.0}, 1.5};
  CHECK(course.at(1.0) == Vec2(2.0, 0.0));
  CHECK(course.at(9.0) == Vec2(3.0, 0.0));
}

constexpr double kSpeed_mps = 2.0;

TEST_CASE("a robot drives straight to its goal, from where its turn carries it") {
  RobotState robot;
  const Prediction at_once{.speed_mps = kSpeed_mps};
  CHECK(own_course(robot, {4.0, 0.0}, at_once).velocity_mps == Vec2(2.0, 0.0));
  CHECK(own_course(robot, {4.0, 0.0}, at_once).lasts_s == Approx(2.0));
  CHECK(own_course(robot, Vec2::Zero(), at_once).lasts_s == 0.0);
  const Prediction turning{.speed_mps = kSpeed_mps, .turn_mps2 = 4.0};
  // From rest it is behind by 2²/8.
  CHECK(own_course(robot, {4.0, 0.0}, turning).from_m == Vec2(-0.5, 0.0));
  robot.twist.velocity_mps = {2.0, 0.0};
  CHECK(own_course(robot, {4.0, 0.0}, turning).from_m == Vec2(Vec2::Zero()));
  robot.twist.velocity_mps = {2.0, 2.0};
  const Course carried = own_course(robot, {4.0, 0.0}, turning);
  CHECK(carried.from_m == Vec2(0.0, 0.5));
  CHECK((carried.at(carried.lasts_s) - Vec2(4.0, 0.0)).norm() <= 1e-12);
}

TEST_CASE("opponents shrink with the way they go until they are met; mates and what stands do not") {
  std::mt19937_64 random(93);
  std::array<int, 3> seen{};  // whole, smaller, gone
  for (int i = 0; i < 2000; ++i) {
    WorldState world;
    std::vector<Obstacle> obstacles;
    for (std::uint16_t k = 0; k < 3; ++k) {
      world.robots.push_back(random_robot(random, k));
      obstacles.push_back(disc(world.robots.back().pose.position_m, 0.2));
    }
    RobotState& opponent = world.robots[2];
    opponent.id.team = Team::blue;
    if (i % 7 == 0) opponent.twist.velocity_mps *= 0.01;
    const RobotState& self = world.robots[0];
    const Vec2 goal = any(random, 6.0);
    const std::vector<double> arrivals_s(3, kForEver_s);
    Prediction prediction{.horizon_s = uniform(random, 0.0, 1.0), .team_horizon_s = 1.0, .speed_mps = kSpeed_mps};
    std::vector<Obstacle> whole;
    predict(obstacles, world, arrivals_s, self, goal, prediction, whole);
    prediction.fade_from_m = uniform(random, 0.0, 1.0);
    prediction.fade_over_m = uniform(random, 0.1, 3.0);
    std::vector<Obstacle> faded;
    predict(obstacles, world, arrivals_s, self, goal, prediction, faded);
    INFO("world " << i << " of seed 93");
    CHECK(faded[0] == whole[0]);
    CHECK(faded[1] == whole[1]);
    if (i % 7 == 0) {
      CHECK(faded[2] == whole[2]);
      continue;
    }
    const double speed_mps = opponent.twist.velocity_mps.norm();
    const double gone_m = prediction.fade_from_m + prediction.fade_over_m;
    const Course theirs{opponent.pose.position_m, opponent.twist.velocity_mps, kForEver_s};
    const Course ours = own_course(self, goal, prediction);
    const double met_s =
        nearest_approach_s(ours, theirs, std::max(prediction.horizon_s, std::min(gone_m / speed_mps, ours.lasts_s)));
    CHECK((faded[2].a - theirs.at(std::min(met_s, prediction.horizon_s))).norm() <= 1e-12);
    const double way_m = speed_mps * met_s;
    // Start and goal may have made it smaller still.
    const double left_m = 0.2 * std::clamp((gone_m - way_m) / prediction.fade_over_m, 0.0, 1.0);
    CHECK(faded[2].radius_m <= left_m + 1e-12);
    const bool is_free = std::min((faded[2].a - self.pose.position_m).norm(), (faded[2].a - goal).norm()) > 0.2;
    if (is_free) CHECK(std::abs(faded[2].radius_m - left_m) <= 1e-12);
    ++seen.at(way_m <= prediction.fade_from_m ? 0 : way_m < gone_m * (1.0 - 1e-9) ? 1 : 2);
  }
  for (const int count : seen) CHECK(count > 50);
}

TEST_CASE("an opponent in the way that creeps on is in the way, however near the goal it gets later") {
  WorldState world;
  world.robots.resize(2);
  world.robots[0].id = {Team::yellow, 0};
  world.robots[0].twist.velocity_mps = {kSpeed_mps, 0.0};
  world.robots[1].id = {Team::blue, 1};
  world.robots[1].pose.position_m = {3.0, 0.1};
  world.robots[1].twist.velocity_mps = {0.12, 0.0};
  const std::vector<Obstacle> obstacles{disc({0.0, 0.0}, 0.2), disc({3.0, 0.1}, 0.2)};
  const Prediction prediction{
      .horizon_s = 0.5, .speed_mps = kSpeed_mps, .turn_mps2 = 6.0, .fade_from_m = 0.6, .fade_over_m = 2.0};
  std::vector<Obstacle> out;
  predict(obstacles, world, std::vector<double>(2, kForEver_s), world.robots[0], {5.0, 0.0}, prediction, out);
  CHECK(out[1].radius_m == 0.2);
}

TEST_CASE("others move to the approach and shrink off start and goal; oneself and what stands stay") {
  std::mt19937_64 random(92);
  int shrunk = 0;
  int after_arrival = 0;
  int stopped = 0;
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
    std::vector<double> arrivals_s;
    for (std::size_t k = 0; k < 5; ++k) arrivals_s.push_back(k % 2 == 0 ? kForEver_s : uniform(random, 0.0, 1.0));
    std::vector<Obstacle> out;
    const Prediction prediction{horizon_s, team_horizon_s, kSpeed_mps, i % 2 == 0 ? 0.0 : 6.0};
    predict(obstacles, world, arrivals_s, self, goal, prediction, out);
    // It does not drive on beyond its goal, and neither do others whose arrival is known.
    const Course ours = own_course(self, goal, prediction);
    REQUIRE(out.size() == obstacles.size());
    CHECK(out[2] == obstacles[2]);
    CHECK(out[5] == obstacles[5]);
    for (std::size_t k = 0; k < 5; ++k) {
      if (k == 2) continue;
      const RobotState& other = world.robots[k];
      INFO("world " << i << " of seed 92, robot " << k);
      const double ahead_s = k == 4 ? horizon_s : team_horizon_s;
      const Course theirs{other.pose.position_m, other.twist.velocity_mps, arrivals_s[k]};
      const double approach_s = nearest_approach_s(ours, theirs, ahead_s);
      after_arrival += approach_s >= ours.lasts_s ? 1 : 0;
      stopped += approach_s > theirs.lasts_s ? 1 : 0;
      const Vec2 expected = theirs.at(approach_s);
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
  CHECK(stopped > 50);
}

}  // namespace
}  // namespace regista
