// Teams whose braking is free of contact, moved exactly as they are told, with wishes that look for trouble: the world
// in which the promise of control/safety/safety_search.h must hold.
#pragma once

#include <functional>
#include <random>
#include <string>

#include "control/safety/safety_search.h"

namespace regista::testing {

/// Undercut by rounding is no contact. Robots already nearer than their margin may approach by 1 nm per choice; an
/// episode has few hundred.
inline constexpr double kContact_m = 1e-6;

struct SafeTeam {
  std::vector<SafetyRobot> robots;
  std::vector<int> intents;  ///< what each robot is up to, see wish()
  Surroundings around;
  RobotLimits limits;
  SafetyParams params{.braking_share = 1.0};  // its teams start as safe as braking with all of it makes them
  double period_s = 0.01;
};

/// A crowd in a small hall with posts, at any speeds from which all of them can brake without touching. Half of the
/// teams keep no margin, so that contact is one decision away.
SafeTeam random_safe_team(std::mt19937_64& random);

/// New wishes: at the nearest mate, where a mate's braking ends, into the walls, any acceleration, anywhere, stop.
void wish(SafeTeam& team, std::mt19937_64& random);

/// Everybody drives from its velocity to `next_mps` at constant acceleration during one period. What touched whom or
/// what meanwhile, judged in continuous time at the true radius; empty for nothing.
std::string move_on(SafeTeam& team, std::span<const Vec2> next_mps);

using Chooser = std::function<std::vector<Vec2>(const SafeTeam&)>;

/// The production search, as it is.
std::vector<Vec2> search_choice(const SafeTeam& team);

/// One team, made from the seed, for so many periods: the first contact, or empty.
std::string run_episode(std::uint64_t seed, int periods, const Chooser& choose);

}  // namespace regista::testing
