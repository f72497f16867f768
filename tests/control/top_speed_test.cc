// The speed a team has shown: of its fastest, of nobody else's, known after a while and forgotten by and by.
#include "control/top_speed.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <span>

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

struct Watched {
  TopSpeed top;
  AccelerationEstimate accelerations;
  void look(const WorldState& world) {
    accelerations.update(world, Team::blue, 0.01, 0.05, 4.0);
    top.update(world, Team::blue, accelerations, 0.01);
  }
  void look(const WorldState& world, double for_s) {
    for (int tick = 0; tick < std::lround(for_s / 0.01); ++tick) look(world);
  }
};

}  // namespace

TEST_CASE("a team's top speed is that of its fastest, known after half a second of driving") {
  Watched seen;
  seen.look({}, 1.0);
  seen.look(two_teams(1.5, 3.0), 1.0);
  CHECK(std::isinf(seen.top.mps()));
  seen.look(two_teams(2.5, 3.0), 0.4);
  CHECK(std::isinf(seen.top.mps()));
  seen.look(two_teams(2.5, 3.0), 0.3);
  CHECK(seen.top.mps() == Approx(2.5));
}

TEST_CASE("what is not seen again is forgotten, but no further than what is seen still") {
  Watched seen;
  seen.look(two_teams(3.0, 0.0), 1.0);
  seen.look(two_teams(2.3, 0.0), 2.0);
  CHECK(seen.top.mps() == Approx(2.6));
  seen.look(two_teams(2.3, 0.0), 10.0);
  CHECK(seen.top.mps() == Approx(2.3));
}

TEST_CASE("while a team stands or drives as in a stop nothing is forgotten") {
  Watched seen;
  seen.look(two_teams(3.0, 0.0), 1.0);
  seen.look(two_teams(1.5, 3.0), 60.0);
  CHECK(seen.top.mps() == Approx(3.0));
}

TEST_CASE("who still speeds up has not shown its top speed") {
  Watched seen;
  const auto speed_up = [&] {
    for (int tick = 0; tick <= 100; ++tick) seen.look(two_teams(0.02 * tick + 0.9, 0.0));
  };
  speed_up();
  CHECK(std::isinf(seen.top.mps()));
  seen.look(two_teams(2.0, 0.0), 1.0);
  CHECK(seen.top.mps() == Approx(2.0));
  speed_up();
  CHECK(seen.top.mps() == Approx(2.0));
  seen.look(two_teams(2.9, 0.0), 0.5);
  CHECK(seen.top.mps() == Approx(2.9));
}

TEST_CASE("of an opponent is said what its own team has shown") {
  const ControlParams params;
  for (const auto& [team, top_mps] : {std::pair{Team::blue, 2.2}, std::pair{Team::yellow, 3.0}}) {
    PresentOpponents opponents;
    std::span<const Opponent> seen;
    for (int tick = 0; tick < 100; ++tick) seen = opponents.update(two_teams(2.2, 3.0), team, params, 0.01);
    REQUIRE_FALSE(seen.empty());
    for (const Opponent& opponent : seen) CHECK(opponent.speed_max_mps == Approx(top_mps));
  }
}

}  // namespace regista
