// The closed loop of the benches of motion: the same seed gives the same bytes, drivers do what they say, and who
// counts contacts counts them right.
#include <atomic>
#include <catch2/catch.hpp>
#include <stdexcept>

#include "modules/bench/motion/contact_watch.h"
#include "modules/bench/motion/crowd_bench.h"
#include "modules/bench/motion/crowd_run.h"
#include "modules/bench/motion/parallel.h"
#include "modules/bench/motion/simple_drivers.h"
#include "sim/random_targets.h"
#include "tests/bench/bench_run.h"

namespace regista::bench {
namespace {

TargetSource fixed(const Targets& targets) {
  return [targets](const WorldState&) -> const Targets& { return targets; };
}

/// Both teams drive straight to one place per robot, without noise or delay.
LoopSetup straight_loop(const std::vector<RobotPlacement>& robots, const Targets& yellow, const Targets& blue) {
  LoopSetup setup = loop_setup(loop_config({}, "none"), 1);
  setup.sim.robots = robots;
  for (const Targets* targets : {&yellow, &blue}) {
    setup.of(targets->team) = {straight_driver(targets->team, setup.sim.params.limits), fixed(*targets)};
  }
  return setup;
}

Targets targets_of(Team team, std::vector<Vec2> places) {
  Targets targets;
  targets.team = team;
  for (std::size_t i = 0; i < places.size(); ++i) {
    targets.targets.push_back({static_cast<std::uint16_t>(i), {places[i], 0.0}, 3.0, false});
  }
  return targets;
}

ContactTally watched(LoopSetup setup, double seconds) {
  ClosedLoop loop(std::move(setup));
  ContactWatch watch(Team::yellow, RobotLimits{}.radius_m);
  loop.run_for(seconds, [&] { watch.observe(loop.simulator(), loop.truth(), loop.dt_s()); });
  const ContactCounts& counts = loop.simulator().contact_counts();
  CHECK(watch.tally().own == counts.own_yellow);
  CHECK(watch.tally().opponent == counts.opponent);
  CHECK(watch.tally().at_fault == counts.at_fault_yellow);
  return watch.tally();
}

double nearest_m(const WorldState& world) {
  double nearest = 1e9;
  for (std::size_t i = 1; i < world.robots.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      nearest = std::min(nearest, (world.robots[i].pose.position_m - world.robots[j].pose.position_m).norm());
    }
  }
  return nearest;
}

/// A crowd's loop with random targets of its own.
struct CrowdLoop {
  RandomTargets yellow, blue;
  ClosedLoop loop;

  explicit CrowdLoop(std::uint64_t seed, bool collide = true)
      : yellow(Team::yellow, division_a(), {}, seed),
        blue(Team::blue, division_a(), {}, seed),
        loop(setup(seed, collide)) {}

 private:
  LoopSetup setup(std::uint64_t seed, bool collide) {
    const Config config = loop_config({}, "noisy");
    LoopSetup out = loop_setup(config, seed);
    out.sim.robots_collide = collide;
    for (const Team team : {Team::yellow, Team::blue}) {
      RandomTargets& targets = team == Team::yellow ? yellow : blue;
      if (collide) {
        out.of(team).driver = std::make_unique<SystemDriver>(team, system_params(config, team));
      } else {
        out.of(team).driver = std::make_unique<PassThroughDriver>(team, system_params(config, team));
      }
      out.of(team).targets = [&targets](const WorldState& world) -> const Targets& { return targets.update(world); };
    }
    return out;
  }
};

TEST_CASE("the same seed gives the same bytes, another seed others") {
  for (const std::uint64_t seed : {1U, 2U}) {
    CrowdLoop first(seed), second(seed), other(seed + 2);
    for (int i = 0; i < 300; ++i) {
      first.loop.tick();
      second.loop.tick();
      other.loop.tick();
      INFO("seed " << seed << ", tick " << i);
      REQUIRE(first.loop.truth() == second.loop.truth());
      REQUIRE(std::equal(first.loop.commands().begin(), first.loop.commands().end(), second.loop.commands().begin()));
    }
    CHECK(first.loop.truth() != other.loop.truth());
  }
}

TEST_CASE("robots that pass through each other do, and nobody counts it") {
  CrowdLoop free(3, false);
  double nearest = 1.0;
  free.loop.run_for(20.0, [&] { nearest = std::min(nearest, nearest_m(free.loop.truth())); });
  CHECK(nearest < 0.1);  // bodies of 0.09 m radius
  CHECK(free.loop.simulator().contact_counts() == ContactCounts{});
  CHECK(free.yellow.reached() > 11);
  CHECK(free.blue.reached() > 11);
}

TEST_CASE("straight drivers reach their targets in about the least time, and meet who is in the way") {
  const std::vector<RobotPlacement> alone{{{Team::yellow, 0}, {{-2.0, 0.0}, 1.0}}};
  ClosedLoop loop(straight_loop(alone, targets_of(Team::yellow, {{1.0, 0.5}}), targets_of(Team::blue, {})));
  loop.run_for(3.0);
  CHECK((loop.truth().robots[0].pose.position_m - Vec2(1.0, 0.5)).norm() < 0.01);
  CHECK(loop.truth().robots[0].twist.velocity_mps.norm() < 0.01);

  const std::vector<RobotPlacement> pair{{{Team::yellow, 0}, {{-2.0, 0.0}, 0.0}},
                                         {{Team::yellow, 1}, {{2.0, 0.0}, 0.0}}};
  const ContactTally own = watched(
      straight_loop(pair, targets_of(Team::yellow, {{2.0, 0.0}, {-2.0, 0.0}}), targets_of(Team::blue, {})), 3.0);
  CHECK(own.own >= 1);
  CHECK(own.own_pushed == 0);
  CHECK(own.own_touching_s > 0.5);
  CHECK(own.opponent == 0);
}

TEST_CASE("contacts with opponents, their fault, and what they push us into") {
  // The opponent drives into Y0, which it pushes into Y1 behind, and that one into Y2, which no opponent ever touches.
  const std::vector<RobotPlacement> robots{{{Team::yellow, 0}, {{0.0, 0.0}, 0.0}},
                                           {{Team::yellow, 1}, {{0.2, 0.0}, 0.0}},
                                           {{Team::yellow, 2}, {{0.4, 0.0}, 0.0}},
                                           {{Team::blue, 0}, {{-2.0, 0.0}, 0.0}}};
  const ContactTally pushed =
      watched(straight_loop(robots, targets_of(Team::yellow, {{0.0, 0.0}, {0.2, 0.0}, {0.4, 0.0}}),
                            targets_of(Team::blue, {{3.0, 0.0}})),
              3.0);
  CHECK(pushed.opponent >= 1);
  CHECK(pushed.at_fault == 0);
  CHECK(pushed.own >= 2);
  CHECK(pushed.own_pushed == pushed.own);
  CHECK(pushed.opponent_touching_s > 0.1);

  // Now ours drives into a standing opponent.
  const std::vector<RobotPlacement> guilty{{{Team::yellow, 0}, {{-2.0, 0.0}, 0.0}},
                                           {{Team::blue, 0}, {{0.0, 0.0}, 0.0}}};
  const ContactTally fault =
      watched(straight_loop(guilty, targets_of(Team::yellow, {{3.0, 0.0}}), targets_of(Team::blue, {{0.0, 0.0}})), 2.0);
  CHECK(fault.opponent >= 1);
  CHECK(fault.at_fault >= 1);
  CHECK(fault.at_fault_pushed < fault.at_fault);  // the first one was its own

  // The same, when it grazed another one just before.
  const std::vector<RobotPlacement> grazing{{{Team::yellow, 0}, {{-2.0, 0.0}, 0.0}},
                                            {{Team::blue, 0}, {{0.0, 0.175}, 0.0}},
                                            {{Team::blue, 1}, {{0.8, -0.05}, 0.0}}};
  const ContactTally grazed = watched(straight_loop(grazing, targets_of(Team::yellow, {{3.0, 0.0}}),
                                                    targets_of(Team::blue, {{0.0, 0.175}, {0.8, -0.05}})),
                                      2.0);
  CHECK(grazed.opponent >= 2);
  CHECK(grazed.at_fault_pushed >= 1);
}

/// Tells a robot to be faster than it can.
class Reckless : public Driver {
 public:
  TeamCommands drive(const FieldGeometry& /*field*/, const WorldState& world, const Targets& /*targets*/,
                     double /*dt_s*/) override {
    RobotCommand command;
    command.velocity.forward_mps = 4.0;
    return {world.captured, Team::yellow, 1, world.sequence, {command}};
  }
};

TEST_CASE("the loop sees who commands more than a robot can") {
  LoopSetup setup = loop_setup(loop_config({}, "none"), 5);
  setup.sim.robots = {{{Team::yellow, 0}, {Vec2::Zero(), 0.0}}};
  setup.of(Team::yellow).driver = std::make_unique<Reckless>();
  ClosedLoop loop(std::move(setup));
  loop.run_for(0.5);
  CHECK(loop.verdict().ticks == 50);
  REQUIRE(loop.verdict().violations.size() == 1);
  CHECK(loop.verdict().violations[0].value == Approx(4.0));
}

TEST_CASE("simple drivers keep the limits whatever the estimate says") {
  const RobotLimits limits;
  WorldState world;
  world.robots.resize(2);
  world.robots[1].id = {Team::blue, 0};
  world.robots[1].pose = {{2.0, 1.0}, 0.5};
  for (const double estimated_mps : {0.0, 3.4, -3.4}) {  // after a hit the estimate may be faster than a robot
    world.robots[1].twist.velocity_mps = {estimated_mps, 0.0};
    for (const auto& driver : {chaser(Team::blue, limits, 3.0), straight_driver(Team::blue, limits)}) {
      const TeamCommands commands = driver->drive(division_a(), world, targets_of(Team::blue, {{-2.0, 1.0}}), 0.01);
      REQUIRE(commands.commands.size() == 1);
      const BodyVelocity& velocity = commands.commands[0].velocity;
      CHECK(std::hypot(velocity.forward_mps, velocity.left_mps) <= limits.speed_max_mps + 1e-9);
    }
  }
}

TEST_CASE("a chaser catches who stands") {
  LoopSetup setup = loop_setup(loop_config({}, "realistic"), 5);
  setup.sim.robots = {{{Team::yellow, 0}, {{2.0, 1.0}, 0.0}}, {{Team::blue, 0}, {{-2.0, -1.0}, 0.0}}};
  setup.of(Team::blue).driver = chaser(Team::blue, RobotLimits{}, 3.0);
  const ContactTally caught = watched(std::move(setup), 3.0);
  CHECK(caught.opponent >= 1);
}

TEST_CASE("work in parallel is done once each, and a failure is told") {
  for (const std::size_t jobs : {1U, 2U, 7U}) {
    std::vector<std::atomic<int>> done(50);
    in_parallel("test", done.size(), jobs, [&](std::size_t i) { ++done[i]; });
    CHECK(std::all_of(done.begin(), done.end(), [](const auto& count) { return count == 1; }));
    CHECK_THROWS_AS(in_parallel("test", 50, jobs,
                                [](std::size_t i) {
                                  if (i == 20) throw std::runtime_error("no");
                                }),
                    std::runtime_error);
  }
}

TEST_CASE("bench crowd") {
  const BenchRun bench;
  CrowdOptions options;
  options.minutes = 0.05;
  options.presets = {"noisy"};
  options.fields = {"B"};
  CHECK(run_crowd(options, bench.run) == 0);
  CHECK(bench.rows("crowd") == 4);
  CHECK(bench.rows("crowd_cost") == 3);
  CHECK(bench.has_plot("crowd_own_B"));
  CHECK(bench.has_plot("crowd_pace_B"));
  options.system.planner = "no_such_planner";
  CHECK_THROWS_AS(run_crowd(options, bench.run), UnknownPlanner);
  options.system = {"", "", {"controller.no_such_key=1"}};
  CHECK_THROWS_AS(run_crowd(options, bench.run), ConfigError);
}

}  // namespace
}  // namespace regista::bench
