// The promises of the team's safety search: no contact whatever is wished, by choices that are reachable, the nearest
// safe ones, and the same every time; and that each thing the proof needs is needed.
#include "control/safety/safety_search.h"

#include <array>
#include <catch2/catch.hpp>

#include "control/motion_limits.h"
#include "planning/uniform.h"
#include "tests/control/safety_model.h"
#include "tests/support/exact_motion.h"
#include "tests/support/share.h"

namespace regista::testing {
namespace {

constexpr int kPeriods = 100;

/// The first contact of so many teams; empty for none.
std::string first_contact(int episodes, const Chooser& choose) {
  for (int seed = 0; seed < episodes; ++seed) {
    const std::string contact = run_episode(static_cast<std::uint64_t>(seed), kPeriods, choose);
    if (!contact.empty()) return contact;
  }
  return "";
}

Chooser with(Flaw flaw) {
  return [flaw](const SafeTeam& team) { return model_choice(team, flaw); };
}

TEST_CASE("the model of the search chooses what the search chooses") {
  int equal = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    std::mt19937_64 random(seed);
    SafeTeam team = random_safe_team(random);
    team.params.hold_s = 0.0;
    for (int period = 0; period < 30; ++period) {
      wish(team, random);
      const std::vector<Vec2> chosen = search_choice(team);
      const std::vector<Vec2> expected = model_choice(team, Flaw::none);
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        INFO("seed " << seed << ", period " << period << ", robot " << i);
        CHECK((chosen[i] - expected[i]).norm() <= 1e-12);
        ++equal;
      }
      REQUIRE(move_on(team, chosen) == "");
    }
  }
  CHECK(equal > 2'000);
}

TEST_CASE("without flaw the model leads to no contact") { CHECK(first_contact(share_of(100), with(Flaw::none)) == ""); }

TEST_CASE("nothing the proof needs can be left out: each flaw leads to contact") {
  constexpr int kEpisodes = 400;  // the first contact ends them, so sanitizers need no smaller share
  const auto flaw = GENERATE(Flaw::partial_periods, Flaw::simultaneous, Flaw::sampled, Flaw::least_bad,
                             Flaw::ignores_margin_breakers, Flaw::own_reach_only);
  INFO("flaw " << static_cast<int>(flaw));
  CHECK(first_contact(kEpisodes, with(flaw)) != "");
}

TEST_CASE("robots within their margin get out of it, which they could not if it were insisted on") {
  for (const Flaw flaw : {Flaw::none, Flaw::insists_on_margin}) {
    SafeTeam team;
    team.params.team_margin_m = 0.02;
    team.params.hold_s = 0.0;
    for (const double x : {-0.095, 0.095}) {
      SafetyRobot robot;
      robot.position_m = {x, 0.0};
      robot.wanted_mps = {x > 0.0 ? 1.0 : -1.0, 0.0};
      team.robots.push_back(robot);
    }
    for (int period = 0; period < 30; ++period) {
      REQUIRE(move_on(team, flaw == Flaw::none ? search_choice(team) : model_choice(team, flaw)) == "");
    }
    const double apart_m = (team.robots[0].position_m - team.robots[1].position_m).norm();
    CHECK((apart_m > 0.3) == (flaw == Flaw::none));
  }
}

TEST_CASE("choices are reachable, within the speed limit, and the same every time") {
  for (std::uint64_t seed = 1000; seed < 1100; ++seed) {
    std::mt19937_64 random(seed);
    SafeTeam team = random_safe_team(random);
    SafetySearch used;  // what was asked before must not matter
    std::vector<Vec2> again;
    for (int period = 0; period < 20; ++period) {
      wish(team, random);
      const std::vector<Vec2> chosen = search_choice(team);
      used.choose(team.robots, {}, team.around, team.limits, team.params, team.period_s, again);
      CHECK(chosen == again);
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        const SafetyRobot& robot = team.robots[i];
        INFO("seed " << seed << ", period " << period << ", robot " << i);
        CHECK((limited_velocity(robot.velocity_mps, chosen[i], team.limits, team.period_s) - chosen[i]).norm() <=
              1e-12);
        CHECK(chosen[i].norm() <= std::max(robot.speed_max_mps, robot.velocity_mps.norm()) + 1e-12);
      }
      REQUIRE(move_on(team, chosen) == "");
    }
  }
}

TEST_CASE("a wish that is safe is granted, and a lone robot brakes before a wall as late as it can") {
  SafeTeam team;
  team.around.half_extent_m = {2.0, 2.0};
  SafetyRobot robot;
  robot.wanted_mps = {3.0, 0.0};
  team.robots = {robot};
  double speed = 0.0;
  double furthest_m = 0.0;
  for (int period = 0; period < 300; ++period) {
    const std::vector<Vec2> chosen = search_choice(team);
    if (team.robots[0].position_m.x() < 0.5) {
      CHECK(chosen[0].x() == Approx(std::min(3.0, speed + team.limits.acceleration_max_mps2 * team.period_s)));
    }
    speed = chosen[0].x();
    REQUIRE(move_on(team, chosen) == "");
    furthest_m = team.robots[0].position_m.x();
  }
  CHECK(furthest_m > 1.95);
}

TEST_CASE("opponents that brake are never touched: seen to brake, or by one that brakes where it cannot keep clear") {
  const bool seen = GENERATE(true, false);
  for (std::uint64_t seed = 2000; seed < 2000 + static_cast<std::uint64_t>(share_of(200)); ++seed) {
    std::mt19937_64 random(seed);
    SafeTeam all = random_safe_team(random);
    if (!seen) all.params.crash_horizon_s = 0.0;
    // The first half of them, opponents of the rest, brake from now on.
    const std::size_t others = all.robots.size() / 2;
    SafetySearch search;
    for (int period = 0; period < 80; ++period) {
      wish(all, random);
      std::vector<Opponent> opponents;
      std::vector<Vec2> next_mps;
      for (std::size_t i = 0; i < others; ++i) {
        const SafetyRobot& robot = all.robots[i];
        const Motion stop =
            braking(robot.position_m, robot.velocity_mps, 0.0, all.limits.braking_max_mps2, all.period_s);
        const Vec2 acceleration = seen ? stop.phases()[0].acceleration_mps2 : Vec2(uniform(random, -3.0, 3.0), 0.0);
        opponents.push_back({robot.position_m, robot.velocity_mps, acceleration});
        next_mps.push_back(stop.settled_s() > 0.0 ? velocity_after(stop.phases()[0], all.period_s)
                                                  : Vec2(Vec2::Zero()));
      }
      std::vector<Vec2> chosen_mps;
      search.choose(std::span<const SafetyRobot>(all.robots).subspan(others), opponents, all.around, all.limits,
                    all.params, all.period_s, chosen_mps);
      next_mps.insert(next_mps.end(), chosen_mps.begin(), chosen_mps.end());
      INFO("seed " << seed << ", period " << period);
      REQUIRE(move_on(all, next_mps) == "");
    }
  }
}

/// Contacts of two teams that keep clear of each other's braking and otherwise do as they please.
int contacts_of_two_teams(double opponent_reaction_s, double opponent_margin_m) {
  int contacts = 0;
  for (std::uint64_t seed = 4000; seed < 4600; ++seed) {
    std::mt19937_64 random(seed);
    SafeTeam all = random_safe_team(random);
    all.params.crash_horizon_s = 0.0;
    all.params.opponent_margin_m = opponent_margin_m;
    all.params.opponent_reaction_s = opponent_reaction_s;
    const std::size_t half = all.robots.size() / 2;
    std::array<SafetySearch, 2> searches;
    for (int period = 0; period < 80; ++period) {
      wish(all, random);
      const std::span<const SafetyRobot> robots(all.robots);
      std::vector<Vec2> next_mps;
      for (const bool first : {true, false}) {
        const std::span<const SafetyRobot> ours = first ? robots.first(half) : robots.subspan(half);
        std::vector<Opponent> opponents;
        for (const SafetyRobot& robot : first ? robots.subspan(half) : robots.first(half)) {
          opponents.push_back({robot.position_m, robot.velocity_mps, Vec2::Zero()});
        }
        std::vector<Vec2> chosen_mps;
        searches[first ? 0 : 1].choose(ours, opponents, all.around, all.limits, all.params, all.period_s, chosen_mps);
        next_mps.insert(next_mps.end(), chosen_mps.begin(), chosen_mps.end());
      }
      if (move_on(all, next_mps).empty()) continue;
      ++contacts;
      break;
    }
  }
  return contacts;
}

TEST_CASE("two teams that choose at once without knowing of each other's choice leave each other room for it") {
  const int with_room = contacts_of_two_teams(SafetyParams{}.opponent_reaction_s, 0.0);
  const int without = contacts_of_two_teams(0.0, 0.0);
  INFO("contacts with room " << with_room << ", without " << without);
  CHECK(without >= 10);
  // Halves are exact on a line; in the plane they are so nearly that the margin takes up the rest.
  CHECK(3 * with_room <= without);
  CHECK(contacts_of_two_teams(SafetyParams{}.opponent_reaction_s, SafetyParams{}.opponent_margin_m) == 0);
  // Rooms for an opponent that moves the end of its braking less than it can are too small.
  CHECK(contacts_of_two_teams(SafetyParams{}.opponent_reaction_s / 8.0, 0.0) > with_room);
}

TEST_CASE("who must stand brakes straight ahead and then stands, whoever comes") {
  for (std::uint64_t seed = 3000; seed < 3040; ++seed) {
    std::mt19937_64 random(seed);
    SafeTeam team = random_safe_team(random);
    SafetySearch search;
    for (int period = 0; period < 90; ++period) {
      wish(team, random);
      SafetyRobot& halted = team.robots.front();
      halted.must_stand = true;
      const Vec2 before_mps = halted.velocity_mps;
      const std::vector<Opponent> opponents{{halted.position_m + Vec2(0.5, 0.0), {-2.0, 0.0}, Vec2::Zero()}};
      std::vector<Vec2> chosen;
      search.choose(team.robots, opponents, team.around, team.limits, team.params, team.period_s, chosen);
      INFO("seed " << seed << ", period " << period);
      CHECK(std::abs(cross(chosen.front(), before_mps)) <= 1e-12);
      CHECK(chosen.front().norm() <= std::max(0.0, before_mps.norm() - 1e-3));
      REQUIRE(move_on(team, chosen) == "");
    }
    CHECK(team.robots.front().velocity_mps == Vec2(Vec2::Zero()));
  }
}

TEST_CASE("who goes through in the line of fire is missed by those that only braking would let hit it") {
  const auto hits = [](double crash_horizon_s) {
    SafeTeam team;
    team.params.crash_horizon_s = crash_horizon_s;
    SafetyRobot robot;
    robot.velocity_mps = {0.0, 2.0};
    robot.wanted_mps = {0.0, 2.0};
    team.robots = {robot};
    Opponent fast{{0.6, 0.4}, {-2.0, 0.0}, Vec2::Zero()};
    SafetySearch search;
    std::vector<Vec2> chosen;
    double least_m = 1.0;
    for (int period = 0; period < 60; ++period) {
      search.choose(team.robots, std::span(&fast, 1), team.around, team.limits, team.params, team.period_s, chosen);
      fast.position_m += team.period_s * fast.velocity_mps;
      REQUIRE(move_on(team, chosen) == "");
      least_m = std::min(least_m, (fast.position_m - team.robots.front().position_m).norm());
    }
    return least_m < 2.0 * team.limits.radius_m;
  };
  CHECK(hits(0.0));
  CHECK_FALSE(hits(SafetyParams{}.crash_horizon_s));
}

}  // namespace
}  // namespace regista::testing
