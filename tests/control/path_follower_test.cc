// Paths into velocities: which leg counts, how fast corners are, how wide paths are left. One robot that obeys at once.
#include "control/path_follower.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "control/corners.h"
#include "control/motion_limits.h"
#include "control/path_legs.h"
#include "control/speed_profile.h"
#include "tests/control/ideal_team.h"

namespace regista {
namespace {

using test::Dice;
using test::distance_to;
using test::from_here;

constexpr double kDt_s = 0.01;

/// Drives the path until at rest at its end, or for too long.
struct Drive {
  double aside_max_m = 0.0;   ///< largest distance from the path
  double arrival_s = -1.0;    ///< first time within 5 mm of the end, slower than 0.1 m/s; -1: never
  double beyond_max_m = 0.0;  ///< largest distance from the end after arrival
  double distance_m = 0.0;    ///< from the end when it stopped
  bool at_rest = false;
};

/// The path as it is, which needs slow corners, or planned anew from where the robot is every period, which does not.
enum class Planning { once, every_period };

Drive drive(const std::vector<Vec2>& path, Planning planning = Planning::once, Vec2 position = Vec2::Zero(),
            Vec2 velocity = Vec2::Zero()) {
  const RobotLimits limits;
  FollowerParams params;
  params.corner_speed_min_mps = planning == Planning::once ? 0.01 : 2.0;
  params.pursuit_distance_m = 0.05;
  params.pursuit_time_s = 0.06;
  Drive result;
  int slow = 0;
  for (int i = 1; i <= 2000 && !result.at_rest; ++i) {
    const std::vector<Vec2> ahead = planning == Planning::once ? path : from_here(path, position);
    const Vec2 wanted = follow_path(ahead, position, velocity, limits, params, kDt_s);
    REQUIRE(wanted.norm() <= limits.speed_max_mps + 1e-9);
    velocity = limited_velocity(velocity, wanted, limits, kDt_s);
    position += velocity * kDt_s;
    result.aside_max_m = std::max(result.aside_max_m, distance_to(path, position));
    result.distance_m = (position - path.back()).norm();
    // Passing by at speed is no arrival.
    const bool there = result.distance_m <= 0.005 && velocity.norm() <= 0.1;
    if (result.arrival_s < 0.0 && there) result.arrival_s = i * kDt_s;
    if (result.arrival_s >= 0.0) result.beyond_max_m = std::max(result.beyond_max_m, result.distance_m);
    slow = velocity.norm() < 1e-3 ? slow + 1 : 0;
    result.at_rest = slow >= 20;  // not only turning round
  }
  return result;
}

std::vector<Vec2> random_path(Dice& dice) {
  std::vector<Vec2> path{dice.point(5.0, 4.0)};
  Vec2 direction = dice.direction();
  const int legs = 2 + static_cast<int>(dice.uniform(0.0, 4.0));
  for (int i = 0; i < legs; ++i) {
    path.push_back(path.back() + direction * dice.uniform(0.2, 2.0));
    direction = rotated(direction, dice.uniform(-1.6, 1.6));
  }
  return path;
}

TEST_CASE("the nearest leg is found and vertices before it are passed") {
  const std::vector<Vec2> path{{0, 0}, {1, 0}, {1, 1}};
  CHECK(nearest_leg(path, {0.3, 0.2}) == 0);
  CHECK(nearest_leg(path, {1.1, 0.5}) == 1);
  CHECK(nearest_leg(path, {1.0, 0.0}) == 1);
  CHECK(nearest_leg(std::vector<Vec2>{{3, 3}}, {1.0, 0.0}) == 0);
  CHECK(legs_ahead(path, {1.1, 0.5}).size() == 1);
  const std::vector<Leg> legs = legs_ahead(path, {0.3, 0.2});
  REQUIRE(legs.size() == 2);
  CHECK(legs[0].turn_rad == Approx(std::numbers::pi / 2));
  CHECK(legs_ahead(std::vector<Vec2>{{3, 3}, {3, 3}}, {1.0, 0.0}).empty());
}

TEST_CASE("corner speeds: none for a straight path, less for sharper bends, an arc by its radius") {
  CHECK(std::isinf(bend_speed(0.0, 0.0, 3.0, 0.02)));
  CHECK(bend_speed(0.5, 0.0, 3.0, 0.02) > bend_speed(1.0, 0.0, 3.0, 0.02));
  // A quarter circle of radius 1 m: v² = a·r.
  CHECK(bend_speed(std::numbers::pi / 2, std::numbers::pi / 2, 3.0, 0.02) == Approx(std::sqrt(3.0)));
}

TEST_CASE("the parabola through a corner passes it at the tolerance") {
  for (const double turn : {0.2, 0.8, 1.5, 2.5}) {
    const double speed = bend_speed(turn, 0.0, 3.0, 0.02);
    const Vec2 before = speed * Vec2(1.0, 0.0);
    const Vec2 after = rotated(before, turn);
    const double time_s = (after - before).norm() / 3.0;
    const Vec2 start = -time_s / 2 * before;
    const Vec2 middle = start + before * (time_s / 2) + (after - before) / time_s * (time_s * time_s / 8);
    CHECK(middle.norm() == Approx(0.02));
  }
}

TEST_CASE("a path of one point is driven to, and none when there") {
  const RobotLimits limits;
  const std::vector<Vec2> path{{1.0, 2.0}};
  CHECK(follow_path(path, {1.0, 2.0}, Vec2::Zero(), limits, {}, kDt_s) == Vec2(0.0, 0.0));
  const Drive result = drive(path, Planning::once, {0.5, 2.5});
  CHECK(result.at_rest);
  CHECK(result.distance_m <= 0.005);
  CHECK(drive({{1, 2}, {1, 2}, {1, 2}}, Planning::once, {0.5, 2.5}).distance_m <= 0.005);
}

TEST_CASE("3 m straight from rest take at most 1.05 of the ideal trapezoid") {
  const Drive result = drive({{0, 0}, {3, 0}});
  const double ideal_s = trapezoid_duration(3.0, 0.0, 0.0, 3.0, 3.0, 4.0);
  CHECK(result.arrival_s <= 1.05 * ideal_s);
  CHECK(result.arrival_s >= 0.95 * ideal_s);
  CHECK(result.aside_max_m <= 1e-9);
}

TEST_CASE("corners of all angles are passed within 35 cm") {
  for (int degrees = 5; degrees < 180; degrees += 5) {
    const Vec2 corner(2.0, 0.0);
    const std::vector<Vec2> path{{0, 0}, corner, corner + rotated({2.0, 0.0}, degrees * std::numbers::pi / 180.0)};
    const Drive result = drive(path);
    INFO(degrees << " degrees");
    // The last leg is driven to its end as a time-optimal motion of its own, so its corner is left that wide.
    CHECK(result.aside_max_m <= 0.35);
    CHECK(result.distance_m <= 0.005);
  }
}

TEST_CASE("arcs drawn as polylines are followed within 18 cm however finely they are drawn") {
  for (const int vertices : {2, 4, 8, 16, 30}) {
    constexpr double kRadius_m = 0.23;
    std::vector<Vec2> path{{0, 0}, {2, 0}};
    for (int k = 1; k <= vertices; ++k) {
      const double angle = std::numbers::pi / 2 * k / vertices;
      path.push_back({2.0 + kRadius_m * std::sin(angle), kRadius_m * (1.0 - std::cos(angle))});
    }
    path.push_back({2.0 + kRadius_m, 2.0});
    INFO(vertices << " vertices");
    CHECK(drive(path).aside_max_m <= 0.18);
  }
}

TEST_CASE("random paths are followed within half a metre, and to within 5 mm of their end") {
  Dice dice(31);
  for (int i = 0; i < 1000; ++i) {
    const std::vector<Vec2> path = random_path(dice);
    const Drive result = drive(path, Planning::once, path.front());
    INFO("path " << i << " of seed 31");
    CHECK(result.aside_max_m <= 0.50);
    CHECK(result.at_rest);
    CHECK(result.distance_m <= 0.005);
    CHECK(result.beyond_max_m <= 0.010);
  }
}

TEST_CASE("from beside the path, moving anyhow, the end is reached without overshoot") {
  Dice dice(32);
  for (int i = 0; i < 500; ++i) {
    const std::vector<Vec2> path = random_path(dice);
    const Vec2 position = path.front() + dice.point(1.0, 1.0);
    const Vec2 direction = dice.direction();
    const Vec2 velocity = direction * dice.uniform(0.0, 3.0);
    for (const Planning planning : {Planning::once, Planning::every_period}) {
      const Drive result = drive(path, planning, position, velocity);
      INFO("path " << i << " of seed 32, " << (planning == Planning::once ? "planned once" : "planned anew"));
      CHECK(result.at_rest);
      CHECK(result.distance_m <= 0.005);
      CHECK(result.beyond_max_m <= 0.010);
    }
  }
}

}  // namespace
}  // namespace regista
