// The whole system as processes over real multicast: up, swapping a planner, killing, ending.
#include <catch2/catch.hpp>
#include <csignal>

#include "tests/regista/ear.h"

namespace regista {
namespace {

RunResult regista(const std::string& url, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), executable("regista"));
  arguments.insert(arguments.end(), {"--lcm-url", url});
  return run(arguments);
}

TEST_CASE("up runs the loop; a planner is swapped, parameters are set, a robot is sent; Ctrl-C leaves nothing") {
  const std::string url = private_bus();
  Ear ear(url);
  Program launcher(up(url));
  REQUIRE(ear.eventually([&] { return ear.all_report(kLoop) && ear.commands() > 10 && ear.plan() != nullptr; }));

  SECTION("a planner") {
    const RunResult use = regista(url, {"planner", "use", "rrt"});
    INFO(use.error);
    CHECK(use.status == 0);
    CHECK(ear.eventually([&] { return ear.plan()->planner == "rrt" && ear.plan()->generation == 1; }));
    const RunResult unknown = regista(url, {"planner", "use", "nonsense", "--team", "Y"});
    CHECK(unknown.status == 1);
    CHECK_THAT(unknown.error, Catch::Contains("rrt") && Catch::Contains("visibility_sampling"));
  }
  SECTION("parameters") {
    const RunResult list = regista(url, {"param", "list", "planner.Y"});
    CHECK(list.status == 0);
    CHECK_THAT(list.out, Catch::Contains("team_margin_m = "));
    CHECK(regista(url, {"param", "set", "planner.Y", "team_margin_m", "0.0625"}).status == 0);
    CHECK(regista(url, {"param", "get", "planner.Y", "team_margin_m"}).out == "0.0625\n");
    const RunResult unknown = regista(url, {"param", "set", "planner.Y", "team_margin", "0.0625"});
    CHECK(unknown.status == 1);
    CHECK_THAT(unknown.error, Catch::Contains("did you mean 'team_margin_m'"));
    CHECK(regista(url, {"param", "set", "planner.Y", "team_margin_m", "-1"}).status == 1);
  }
  SECTION("the referee") {
    CHECK(regista(url, {"referee", "stop"}).status == 0);
    CHECK(ear.eventually([&] { return ear.plan()->target.speed_max_mps < 1.5; }));
    CHECK(regista(url, {"referee", "force_start"}).status == 0);
    CHECK(ear.eventually([&] { return ear.plan()->target.speed_max_mps > 2.0; }));
  }
  SECTION("a robot") {
    const RunResult sent = regista(url, {"goto", "Y3", "1.5", "-0.25", "90"});
    INFO(sent.error);
    CHECK(sent.status == 0);
    CHECK(ear.eventually([&] {
      for (const Target& target : ear.targets()->targets) {
        if (target.robot == 3) return target.pose.position_m.isApprox(Vec2(1.5, -0.25));
      }
      return false;
    }));
    CHECK(regista(url, {"goto", "Y3", "--release"}).status == 0);
    CHECK(regista(url, {"goto", "G3", "1", "1"}).status == 1);
  }

  launcher.send(SIGINT);
  CHECK(launcher.wait() == 0);
  CHECK(processes_with(url).empty());
}

TEST_CASE("whatever is killed comes back, and the others run on") {
  const std::string url = private_bus();
  Ear ear(url);
  Program launcher(up(url));
  REQUIRE(ear.eventually([&] { return ear.all_report(kLoop); }));
  std::map<std::string, int> before;
  for (const std::string& module : kLoop) before[module] = ear.pid(module);
  for (const char* victim : {"planner.Y", "sim"}) {
    kill(before[victim], SIGKILL);
    CHECK(ear.eventually([&] { return ear.pid(victim) != before[victim]; }));
    before[victim] = ear.pid(victim);
  }
  const std::int64_t commands = ear.commands();
  CHECK(ear.eventually([&] { return ear.commands() > commands + 10; }));
  for (const std::string& module : kLoop) CHECK(ear.pid(module) == before[module]);
  CHECK_THAT(launcher.out(), Catch::Contains("planner.Y was killed by signal 9"));
  launcher.send(SIGTERM);
  CHECK(launcher.wait() == 0);
  CHECK(processes_with(url).empty());
}

TEST_CASE("a scenario of a real field starts the league's protocols in the simulator's place") {
  const std::string url = private_bus();
  Ear ear(url);
  Program launcher({executable("regista"), "up", "ssl", "--lcm-url", url, "--no-task"});
  CHECK(ear.eventually([&] {
    return ear.all_report({"ssl-vision", "ssl-referee", "ssl-radio", "world-model", "planner.B"});
  }));
  CHECK(processes_with("regista-sim --lcm-url " + url).empty());
  CHECK(processes_with("regista-task --lcm-url " + url).empty());
  launcher.send(SIGINT);
  CHECK(launcher.wait() == 0);
  CHECK(processes_with(url).empty());
}

TEST_CASE("a launcher that is killed outright takes its modules with it") {
  const std::string url = private_bus();
  Ear ear(url);
  Program launcher(up(url));
  REQUIRE(ear.eventually([&] { return ear.all_report(kLoop); }));
  launcher.send(SIGKILL);
  CHECK(eventually([&] { return processes_with(url).empty(); }));
}

}  // namespace
}  // namespace regista
