// The whole loop in lock step: within the rules, safe when parts of it die, and planners swapped on the way.
#include "modules/lockstep/lock_step.h"

#include <catch2/catch.hpp>

#include "tests/modules/loop_fixture.h"
#include "tests/modules/samples.h"

using namespace regista;
using namespace regista::loop_test;

TEST_CASE("the main job reaches its targets within the rules of the field") {
  const RunSummary summary = run_scenario(
      crossing({"scenario.duration_s=20", "scenario.expect.targets_per_team_min=30"}), {}, real_stopwatch());
  for (const Violation& violation : summary.violations) INFO(to_string(violation));
  CHECK(summary.violations.empty());
  CHECK(summary.reached_yellow >= 30);
  CHECK(summary.reached_blue >= 30);
}

TEST_CASE("a target that cannot be reached in time breaks the expectation") {
  const RunSummary summary = run_scenario(
      crossing({"scenario.duration_s=1", "scenario.expect.targets_per_team_min=30"}), {}, real_stopwatch());
  CHECK(summary.violations.size() == 2);
}

TEST_CASE("planners are swapped while the robots drive, without a jump") {
  LockStep loop{Time{}};
  const WholeLoop modules = add_whole_loop(loop, few_robots(), no_time);
  Mailbox<Reply> replies(loop.bus(), channels::reply());
  std::map<RobotId, Vec2> before;
  const RobotLimits& limits = modules.sim->simulator().params().limits;
  const double largest_step_mps = std::max(limits.acceleration_max_mps2, limits.braking_max_mps2) * kPeriod_s + 1e-6;
  std::int64_t id = 1;
  for (const char* planner :
       {"rrt", "visibility_sampling_single", "visibility_sampling", "rrt", "visibility_sampling"}) {
    loop.bus().publish(channels::request(), {loop.now(), id++, "planner.Y", "planner.use", planner, ""});
    double fastest = 0.0;
    for (int frame = 0; frame < 150; ++frame) {
      run_for(loop, kPeriod_s);
      for (const RobotState& robot : modules.sim->simulator().truth().robots) {
        const auto last = before.find(robot.id);
        INFO(planner << ", " << to_string(robot.id) << " at " << to_seconds(loop.now() - Time{}) << " s");
        if (last != before.end()) REQUIRE((robot.twist.velocity_mps - last->second).norm() <= largest_step_mps);
        before[robot.id] = robot.twist.velocity_mps;
      }
      fastest = std::max(fastest, fastest_mps(modules, Team::yellow));
    }
    CHECK(replies.take()->accepted);
    CHECK(modules.planners.at(Team::yellow)->note() == planner);
    CHECK(fastest > 1.0);
  }
  CHECK(modules.sim->simulator().contacts().empty());  // else the velocities above were not the modules' doing
  loop.bus().publish(channels::request(), {loop.now(), id, "planner.Y", "planner.use", "teleport", ""});
  run_for(loop, kPeriod_s);
  CHECK_FALSE(replies.newest()->accepted);
  CHECK(replies.newest()->text.find("visibility_sampling_single") != std::string::npos);
  CHECK(modules.planners.at(Team::yellow)->note() == "visibility_sampling");
}

TEST_CASE("whatever dies, its robots stop and the others drive on; when it returns, so do they") {
  const Config config = few_robots();
  LockStep loop{Time{}};
  const WholeLoop modules = add_whole_loop(loop, config, no_time);
  run_for(loop, 2.0);
  REQUIRE(fastest_during_mps(loop, modules, Team::yellow, 1.5) > 1.0);

  SECTION("planner") {
    loop.remove(*modules.planners.at(Team::yellow));
    run_for(loop, kStopsWithin_s);
    CHECK(fastest_mps(modules, Team::yellow) < 1e-3);
    CHECK(fastest_during_mps(loop, modules, Team::blue, 1.5) > 1.0);
    add_planner(loop, config, Team::yellow, no_time);
  }
  SECTION("controller") {
    loop.remove(*modules.controllers.at(Team::yellow));
    run_for(loop, kStopsWithin_s);
    CHECK(fastest_mps(modules, Team::yellow) < 1e-3);
    CHECK(fastest_during_mps(loop, modules, Team::blue, 1.5) > 1.0);
    add_controller(loop, config, Team::yellow, no_time);
  }
  SECTION("world model") {
    loop.remove(*modules.world_model);
    run_for(loop, kStopsWithin_s);
    CHECK(fastest_mps(modules, Team::yellow) < 1e-3);
    CHECK(fastest_mps(modules, Team::blue) < 1e-3);
    add_world_model(loop, config, no_time);
  }
  SECTION("task") {
    loop.remove(*modules.task);
    run_for(loop, kStopsWithin_s);
    CHECK(fastest_mps(modules, Team::yellow) < 1e-3);
    CHECK(fastest_mps(modules, Team::blue) < 1e-3);
    add_task(loop, config);
  }
  CHECK(fastest_during_mps(loop, modules, Team::yellow, 3.0) > 1.0);
  CHECK(fastest_during_mps(loop, modules, Team::blue, 3.0) > 1.0);
}

TEST_CASE("a planner that lags behind vision is no planner") {
  const Config config = few_robots();
  LockStep loop{Time{}};
  const WholeLoop modules = add_whole_loop(loop, config, no_time);
  run_for(loop, 3.0);
  // From now on old plans come again and again, fresh as messages, stale as plans.
  std::vector<RobotPlan> old;
  Listener<RobotPlan> listener(loop.bus(), channels::plans(Team::yellow), [&](RobotPlan plan) { old.push_back(plan); });
  run_for(loop, kPeriod_s);
  REQUIRE(old.size() == 2);
  loop.remove(*modules.planners.at(Team::yellow));
  const std::vector<RobotPlan> repeated = old;
  for (double t = 0.0; t < kStopsWithin_s; t += kPeriod_s) {
    for (const RobotPlan& plan : repeated) loop.bus().publish(channels::plan(plan.robot), plan);
    run_for(loop, kPeriod_s);
  }
  CHECK(fastest_mps(modules, Team::yellow) < 1e-3);
}

TEST_CASE("one robot's plan coming twice makes no set complete") {
  Time now{};
  Bus bus("memq://", [&] { return now; });
  ControllerModule controller(bus, Team::yellow, {}, no_time);
  WorldState world;
  world.sequence = 7;
  world.robots.resize(2);
  world.robots[1].id.number = 1;
  bus.publish(channels::world_state(), world);
  RobotPlan plan;
  plan.world_sequence = 7;
  plan.set_size = 2;
  plan.plan = {PlanStatus::ok, false, false, {Vec2::Zero(), Vec2(1.0, 0.0)}, 1.0, ""};
  const auto drain = [&] {
    while (bus.handle(Duration::zero())) {
    }
  };
  bus.publish(channels::plan(plan.robot), plan);
  bus.publish(channels::plan(plan.robot), plan);
  drain();
  CHECK_FALSE(controller.ready());
  plan.robot.number = 1;
  plan.target.robot = 1;
  bus.publish(channels::plan(plan.robot), plan);
  drain();
  CHECK(controller.ready());
}

TEST_CASE("whatever decodes, however damaged, stops no module") {
  const Config config = few_robots();
  LockStep loop{Time{}};
  const WholeLoop modules = add_whole_loop(loop, config, no_time);
  std::vector<std::pair<std::string, std::vector<std::uint8_t>>> seen;
  const auto tap = loop.bus().subscribe_raw(".*", [&](const std::string& channel, std::span<const std::uint8_t> bytes) {
    if (seen.size() < 2000) seen.emplace_back(channel, std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
  });
  run_for(loop, 1.0);
  samples::Source source(11);
  for (int i = 0; i < 4000; ++i) {
    auto [channel, bytes] = seen[source.below(seen.size())];
    for (std::uint64_t hits = 1 + source.below(3); hits > 0; --hits) {
      bytes[8 + source.below(bytes.size() - 8)] = static_cast<std::uint8_t>(source.below(256));
    }
    INFO("damage " << i << " on " << channel);
    REQUIRE_NOTHROW(loop.inject(channel, bytes));
    if (i % 20 == 0) REQUIRE_NOTHROW(run_for(loop, kPeriod_s));
  }
  CHECK(loop.bus().reception().refused > 100);
  REQUIRE_NOTHROW(run_for(loop, 5.0));
  CHECK(fastest_during_mps(loop, modules, Team::yellow, 3.0) > 1.0);
}

TEST_CASE("robots are sent by request and come back to the task") {
  LockStep loop{Time{}};
  const WholeLoop modules = add_whole_loop(loop, few_robots(), no_time);
  run_for(loop, 0.5);
  loop.bus().publish(channels::request(), {loop.now(), 1, "task", "task.goto", "Y1", "1.5 -2 0.5"});
  run_for(loop, 8.0);
  const WorldState truth = modules.sim->simulator().truth();
  const RobotState* robot = find_robot(truth, {Team::yellow, 1});
  REQUIRE(robot != nullptr);
  CHECK((robot->pose.position_m - Vec2(1.5, -2.0)).norm() < 0.02);
  CHECK(std::abs(wrap_angle(robot->pose.heading_rad - 0.5)) < 0.05);
  Mailbox<Reply> replies(loop.bus(), channels::reply());
  for (const auto& [key, value] : {std::pair{"Y99", "0 0"}, {"Y1", "1000 0"}, {"Y1", "here"}}) {
    loop.bus().publish(channels::request(), {loop.now(), 10 + static_cast<std::int64_t>(value[0]) + key[1], "task",
                                             "task.goto", key, value});
    run_for(loop, kPeriod_s);
    INFO(key << " to " << value << ": " << replies.newest()->text);
    CHECK_FALSE(replies.take()->accepted);
  }
  loop.bus().publish(channels::request(), {loop.now(), 2, "task", "task.release", "Y1", ""});
  CHECK(fastest_during_mps(loop, modules, Team::yellow, 2.0) > 1.0);
}
