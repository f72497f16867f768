#include "tests/support/safe_teams.h"

#include "planning/clearance.h"
#include "planning/uniform.h"
#include "tests/support/exact_motion.h"

namespace regista::testing {
namespace {

constexpr int kIntents = 6;
constexpr double kNewIntent = 0.03;  ///< per period
constexpr double kMore_m = 1e-7;     ///< that a first state keeps beyond touching

Vec2 direction(std::mt19937_64& random) {
  return rotated(Vec2::UnitX(), uniform(random, -std::numbers::pi, std::numbers::pi));
}

Vec2 any_vector(std::mt19937_64& random, double length_max) {
  const Vec2 along = direction(random);
  return uniform(random, 0.0, length_max) * along;
}

Vec2 point_in(std::mt19937_64& random, const Vec2& half) {
  const double x = uniform(random, -half.x(), half.x());
  return {x, uniform(random, -half.y(), half.y())};
}

Motion braking_of(const SafeTeam& team, const SafetyRobot& robot) {
  return braking(robot.position_m, robot.velocity_mps, 0.0, team.limits.braking_max_mps2, team.period_s);
}

bool may_join(const SafeTeam& team, const SafetyRobot& robot) {
  const Motion motion = braking_of(team, robot);
  if ((furthest(motion).array() > team.around.half_extent_m.array()).any()) return false;
  for (const Obstacle& shape : team.around.shapes) {
    if (least_clearance(motion, shape, 2.0 * kMore_m) < kMore_m) return false;
  }
  return std::all_of(team.robots.begin(), team.robots.end(), [&](const SafetyRobot& mate) {
    const double touching_m = 2.0 * team.limits.radius_m;
    return least_distance(motion, braking_of(team, mate), touching_m + 2.0 * kMore_m) > touching_m + kMore_m;
  });
}

std::size_t nearest_mate(const SafeTeam& team, std::size_t self) {
  std::size_t nearest = self;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < team.robots.size(); ++i) {
    const double distance_m = (team.robots[i].position_m - team.robots[self].position_m).norm();
    if (i == self || distance_m >= least_m) continue;
    least_m = distance_m;
    nearest = i;
  }
  return nearest;
}

Vec2 towards(const SafetyRobot& robot, const Vec2& goal_m) {
  const Vec2 way = goal_m - robot.position_m;
  return way.isZero(0.0) ? Vec2(Vec2::Zero()) : Vec2(robot.speed_max_mps * way.normalized());
}

Vec2 wish_of(const SafeTeam& team, std::size_t self, std::mt19937_64& random) {
  const SafetyRobot& robot = team.robots[self];
  const SafetyRobot& mate = team.robots[nearest_mate(team, self)];
  switch (team.intents[self]) {
    case 0:
      return towards(robot, mate.position_m);
    case 1:
      return towards(robot, braking_of(team, mate).phases().back().position_m);
    case 2:
      return towards(robot, 100.0 * robot.position_m);  // into the nearest wall or so
    case 3:
      return robot.velocity_mps + any_vector(random, 0.1);
    case 4:
      return any_vector(random, 5.0);
    default:
      return Vec2::Zero();
  }
}

/// The period's motion of one robot.
Phase phase_to(const SafeTeam& team, std::size_t robot, const Vec2& next_mps) {
  const SafetyRobot& self = team.robots[robot];
  return {0.0, self.position_m, self.velocity_mps, (next_mps - self.velocity_mps) / team.period_s};
}

std::string contact_of(const SafeTeam& team, std::span<const Vec2> next_mps, std::size_t i) {
  const Phase phase = phase_to(team, i, next_mps[i]);
  const std::string who = "robot " + std::to_string(i);
  const Vec2 outside_m = furthest(phase, team.period_s) - team.around.half_extent_m;
  if (outside_m.maxCoeff() > kContact_m) return who + " is outside by " + std::to_string(outside_m.maxCoeff()) + " m";
  Motion motion(phase.position_m, phase.velocity_mps);
  motion.then(phase.acceleration_mps2, team.period_s);
  for (const Obstacle& shape : team.around.shapes) {
    if (least_clearance(motion, shape, 0.0) < -kContact_m) return who + " meets a post";
  }
  for (std::size_t j = 0; j < i; ++j) {
    const Phase other = phase_to(team, j, next_mps[j]);
    const Phase relative{0.0, phase.position_m - other.position_m, phase.velocity_mps - other.velocity_mps,
                         phase.acceleration_mps2 - other.acceleration_mps2};
    const double touching_m = 2.0 * team.limits.radius_m;
    const double undercut_m = touching_m - least_distance(relative, team.period_s, touching_m);
    if (undercut_m > kContact_m) {
      return who + " meets robot " + std::to_string(j) + " by " + std::to_string(1e3 * undercut_m) + " mm";
    }
  }
  return "";
}

}  // namespace

SafeTeam random_safe_team(std::mt19937_64& random) {
  SafeTeam team;
  team.params.team_margin_m = random() % 2 == 0 ? 0.0 : uniform(random, 0.0, 0.04);
  team.params.hold_s = random() % 2 == 0 ? 0.0 : uniform(random, 0.0, 0.3);
  team.around.half_extent_m = {uniform(random, 0.6, 2.5), uniform(random, 0.6, 2.5)};
  for (std::uint64_t i = random() % 3; i > 0; --i) {
    const double radius_m = uniform(random, 0.1, 0.3);
    team.around.shapes.push_back(disc(point_in(random, team.around.half_extent_m), radius_m));
  }
  const std::size_t robots = 2 + random() % 10;
  for (int tries = 0; tries < 300 && team.robots.size() < robots; ++tries) {
    SafetyRobot robot;
    robot.position_m = point_in(random, team.around.half_extent_m);
    robot.velocity_mps = any_vector(random, team.limits.speed_max_mps);
    robot.speed_max_mps = random() % 4 == 0 ? uniform(random, 0.5, 3.0) : team.limits.speed_max_mps;
    if (may_join(team, robot)) team.robots.push_back(robot);
  }
  team.intents.assign(team.robots.size(), 0);
  for (int& intent : team.intents) intent = static_cast<int>(random() % kIntents);
  return team;
}

void wish(SafeTeam& team, std::mt19937_64& random) {
  for (std::size_t i = 0; i < team.robots.size(); ++i) {
    if (uniform(random) < kNewIntent) team.intents[i] = static_cast<int>(random() % kIntents);
    team.robots[i].wanted_mps = wish_of(team, i, random);
  }
}

std::string move_on(SafeTeam& team, std::span<const Vec2> next_mps) {
  std::string contact;
  for (std::size_t i = 0; i < team.robots.size() && contact.empty(); ++i) contact = contact_of(team, next_mps, i);
  for (std::size_t i = 0; i < team.robots.size(); ++i) {
    team.robots[i].position_m = position_after(phase_to(team, i, next_mps[i]), team.period_s);
    team.robots[i].velocity_mps = next_mps[i];
  }
  return contact;
}

std::vector<Vec2> search_choice(const SafeTeam& team) {
  SafetySearch search;
  std::vector<Vec2> chosen_mps;
  search.choose(team.robots, {}, team.around, team.limits, team.params, team.period_s, chosen_mps);
  return chosen_mps;
}

std::string run_episode(std::uint64_t seed, int periods, const Chooser& choose) {
  std::mt19937_64 random(seed);
  SafeTeam team = random_safe_team(random);
  for (int period = 0; period < periods; ++period) {
    wish(team, random);
    const std::string contact = move_on(team, choose(team));
    if (!contact.empty()) return "seed " + std::to_string(seed) + ", period " + std::to_string(period) + ": " + contact;
  }
  return "";
}

}  // namespace regista::testing
