// The rules of the game over the whole loop: speeds and distances kept, and who stands where he must not leaves at
// once.
#include <catch2/catch.hpp>

#include "sim/rule_validators.h"
#include "tests/modules/loop_fixture.h"

using namespace regista;
using namespace regista::loop_test;

namespace {

constexpr double kRadius_m = 0.09;

/// The whole loop with a hand for requests and validators.
struct Match {
  LockStep loop{Time{}};
  WholeLoop modules;
  std::int64_t requests = 0;

  explicit Match(const std::vector<std::string>& settings)
      : modules(add_whole_loop(loop, crossing(settings), no_time)) {}

  void ask(const std::string& module, const std::string& verb, const std::string& key, const std::string& value = "") {
    loop.bus().publish(channels::request(), {loop.now(), ++requests, module, verb, key, value});
  }
  void referee(const std::string& command, const std::string& place = "") {
    ask("task", "task.referee", command, place);
  }
  void put(const std::string& robot, const std::string& place) { ask("sim", "sim.teleport", robot, place); }
  WorldState truth() const { return modules.sim->simulator().truth(); }
  Vec2 place(RobotId robot) const { return find_robot(truth(), robot)->pose.position_m; }

  std::vector<Violation> watch(std::vector<Validator> validators, double seconds) {
    Validation validation(std::move(validators));
    for (double t = 0.0; t < seconds; t += kPeriod_s) {
      run_for(loop, kPeriod_s);
      const WorldState world = truth();
      validation.observe({world, modules.sim->simulator().contact_counts()});
    }
    return validation.violations();
  }
};

void check_none(const std::vector<Violation>& violations) {
  for (const Violation& violation : violations) FAIL_CHECK(to_string(violation));
}

}  // namespace

TEST_CASE("in stop all robots slow down and keep off ball and areas") {
  for (const char* preset : {"none", "noisy"}) {
    INFO(preset);
    Match match({std::string("scenario.sim_preset=") + preset});
    run_for(match.loop, 3.0);
    REQUIRE(fastest_mps(match.modules, Team::yellow) > 1.5);
    match.referee("stop");
    match.put("ball", "-1.5 0.5");
    match.put("Y3", "-1.45 0.6");  // beside the ball
    match.put("B4", "-1.9 0.5");
    check_none(match.watch({stop_speed_kept(), ball_distance_kept(std::nullopt, kRadius_m, Grace::at_first),
                            area_distance_kept(division_a(), kRadius_m, Grace::at_first)},
                           8.0));
    CHECK(fastest_during_mps(match.loop, match.modules, Team::yellow, 1.0) > 1.0);  // they drive on all the same
    match.referee("force_start");
    CHECK(fastest_during_mps(match.loop, match.modules, Team::yellow, 3.0) > 1.5);
  }
}

TEST_CASE("without the rules robots break them: the judges can fail") {
  Match driving({"scenario.sim_preset=none"});
  run_for(driving.loop, 3.0);
  const auto too_fast = driving.watch({stop_speed_kept()}, 3.0);
  REQUIRE(too_fast.size() == 1);
  CHECK(too_fast[0].value > 1.5);

  Match standing({"scenario.sim_preset=none", "scenario.task=stand"});
  run_for(standing.loop, 0.5);
  standing.put("ball", "-3 2");
  standing.put("Y3", "-3.2 2");
  standing.ask("task", "task.goto", "Y3", "-3.2 2");
  const auto too_near = standing.watch({ball_distance_kept(std::nullopt, kRadius_m, Grace::at_first)}, 3.0);
  REQUIRE(too_near.size() == 1);
  CHECK(too_near[0].robot == RobotId{Team::yellow, 3});
}

TEST_CASE("a placement's line is left by the shortest way and kept free by the other team only") {
  for (const char* preset : {"none", "noisy"}) {
    INFO(preset);
    Match match({std::string("scenario.sim_preset=") + preset, "scenario.robots_per_team=4"});
    run_for(match.loop, 0.5);
    match.put("ball", "-2 0");
    run_for(match.loop, 0.1);
    match.ask("task", "task.goto", "Y1", "0.5 0.2");  // inside: it shall wait outside
    match.ask("task", "task.goto", "B1", "0.5 -0.2");
    match.put("Y1", "0 0.15");
    match.put("Y2", "-0.6 -0.1");
    match.put("Y3", "2.2 0");  // beyond the end
    match.referee("ball_placement_blue", "2 0");
    run_for(match.loop, 0.2);
    // Sideways is shortest; a little is still driven as told before.
    for (const std::uint16_t robot : std::initializer_list<std::uint16_t>{1, 2}) {
      const Vec2 place = match.place({Team::yellow, robot});
      INFO("Y" << robot << " at " << place.transpose());
      CHECK(std::abs(place.x() - (robot == 1 ? 0.0 : -0.6)) < 0.1);
    }
    check_none(match.watch({placement_kept(Team::blue, {2, 0}, kRadius_m, Grace::at_first)}, 8.0));
    CHECK((match.place({Team::blue, 1}) - Vec2(0.5, -0.2)).norm() < 0.05);
    CHECK(std::abs(match.place({Team::yellow, 1}).x() - 0.5) < 0.1);
  }
}

TEST_CASE("who stands in a defence area without leave is out within two seconds, the goalkeeper stays") {
  const FieldGeometry field = division_a();
  for (const std::string place : {"-5.2 0.9", "5.2 -0.9", "-4.5 0.2", "4.4 1.5", "-5.8 -1.4"}) {
    INFO(place);
    Match match({"scenario.sim_preset=noisy", "scenario.robots_per_team=4", "scenario.task=stand"});
    run_for(match.loop, 0.3);
    match.ask("task", "task.goto", "Y2", "-1 0");
    match.put("Y2", place);
    run_for(match.loop, 0.05);
    const Vec2 began = match.place({Team::yellow, 2});
    run_for(match.loop, 2.0);
    const Vec2 ended = match.place({Team::yellow, 2});
    const double depth = field.length_m / 2.0 - field.defence_depth_m;
    CAPTURE(began.transpose(), ended.transpose());
    const double out_m = kRadius_m - 0.02;  // corners may be rounded by so much on the way on
    CHECK((std::abs(ended.x()) < depth - out_m || std::abs(ended.y()) > field.defence_width_m / 2.0 + out_m));
    CHECK(std::abs(match.place({Team::yellow, 0}).x()) > depth);
  }
}

TEST_CASE("at halt everybody stands, and drives on at the next start") {
  Match match({"scenario.sim_preset=noisy"});
  run_for(match.loop, 3.0);
  match.referee("halt");
  check_none(match.watch({halt_kept()}, 4.0));
  for (const RobotState& robot : match.truth().robots) CHECK(std::abs(robot.twist.angular_radps) < 0.05);
  match.referee("normal_start");
  CHECK(fastest_during_mps(match.loop, match.modules, Team::blue, 3.0) > 1.5);
}

TEST_CASE("a scenario states its referee, and is judged by it") {
  const RunSummary summary = run_scenario(
      crossing({"scenario.duration_s=6", "scenario.referee=stop", "scenario.expect.targets_per_team_min=0"}), {},
      no_time);
  check_none(summary.violations);
  CHECK_THROWS_AS(crossing({"scenario.referee=dance"}).scenario(), ConfigError);
}
