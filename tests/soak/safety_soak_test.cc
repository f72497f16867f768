// Team-mates and walls are never touched: very many robot-steps from random safe states with wishes that look for
// trouble. A hundredth of them by default; ./dev soak safety runs all.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <string_view>

#include "tests/support/safe_teams.h"
#include "tests/support/share.h"

namespace regista::testing {
namespace {

constexpr int kRobotSteps = 10'000'000;
constexpr int kShareInTests = 100;
constexpr int kPeriods = 150;

}  // namespace

TEST_CASE("no team-mate and no wall is ever touched") {
  const char* named = std::getenv("REGISTA_SOAK");
  if (named != nullptr && std::string_view(named) != "safety") return;
  const int all = named != nullptr ? kRobotSteps : share_of(kRobotSteps / kShareInTests);
  int steps = 0;
  const Chooser counting = [&](const SafeTeam& team) {
    steps += static_cast<int>(team.robots.size());
    return search_choice(team);
  };
  for (std::uint64_t seed = 10'000; steps < all; ++seed) REQUIRE(run_episode(seed, kPeriods, counting) == "");
}

}  // namespace regista::testing
