// The speed a team has shown: of its fastest, of nobody else's, known after a while and forgotten by and by.
#include "control/top_speed.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "control/present_opponents.h"

namespace regista {
namespace {

WorldState two_teams(double blue_mps, double yellow_mps) {
  WorldState world;
  world.robots.resize(3);
  world.robots[0].id = {Team::blue, 1};
  world.robots[1].id = {Team::blue, 2};
  world.robots[2].id = {Team::yellow, 1};
  world.robots[1].twist.velocity_mps = {0.6 * blue_mps, -0.8 * blue_mps};
  world.robots[2].twist.velocity_mps = {yellow_mps, 0.0};
  return world;
}

void watch(TopSpeed& top, const WorldState& world, double for_s) {
  for (int tick = 0; tick < std::lround(for_s / 0.01); ++tick) top.update(world, Team::blue, 0.01);
}

}  // namespace

TEST_CASE("a team's top speed is that of its fastest, known after half a second") {
  TopSpeed top;
  CHECK(std::isinf(top.mps()));
  watch(top, two_teams(2.5, 3.0), 0.4);
  CHECK(std::isinf(top.mps()));
  watch(top, two_teams(2.5, 3.0), 0.2);
  CHECK(top.mps() == Approx(2.5));
}

TEST_CASE("what is seen only once is forgotten, but no further than what is seen still") {
  TopSpeed top;
  watch(top, two_teams(3.0, 0.0), 1.0);
  watch(top, two_teams(2.3, 0.0), 2.0);
  CHECK(top.mps() == Approx(2.6));
  watch(top, two_teams(2.3, 0.0), 10.0);
  CHECK(top.mps() == Approx(2.3));
}

TEST_CASE("a team that is slow for a while is still expected to get to 2 m/s") {
  TopSpeed top;
  watch(top, two_teams(2.6, 0.0), 1.0);
  watch(top, two_teams(0.0, 0.0), 60.0);
  CHECK(top.mps() == 2.0);
}

TEST_CASE("opponents are told apart by what their own team has shown") {
  PresentOpponents opponents;
  const ControlParams params;
  std::span<const Opponent> seen;
  for (int tick = 0; tick < 100; ++tick) seen = opponents.update(two_teams(2.2, 3.0), Team::blue, params, 0.01);
  REQUIRE(seen.size() == 2);
  CHECK(seen[0].speed_max_mps == Approx(2.2));
  CHECK(seen[1].speed_max_mps == Approx(2.2));
}

}  // namespace regista
