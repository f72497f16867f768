// The pure parts of `regista up`: which modules with which flags, when to restart, how the table looks.
#include <algorithm>
#include <catch2/catch.hpp>

#include "modules/regista/module_set.h"
#include "modules/regista/restart_policy.h"
#include "modules/regista/status_table.h"

namespace regista {
namespace {

std::vector<std::string> names(const LaunchOptions& options) {
  std::vector<std::string> out;
  for (const ChildSpec& spec : modules_for(options)) out.push_back(spec.name);
  return out;
}

bool has(const std::vector<std::string>& list, const std::string& text) {
  return std::count(list.begin(), list.end(), text) > 0;
}

TEST_CASE("the modules of a simulated field, one planner and controller per team") {
  CHECK(names({}) == std::vector<std::string>{"sim", "world-model", "task", "planner.Y", "planner.B", "controller.Y",
                                              "controller.B"});
}

TEST_CASE("a real field takes the place of the simulator") {
  LaunchOptions options;
  options.real_field = true;
  const auto modules = names(options);
  CHECK(has(modules, "ssl-vision"));
  CHECK(has(modules, "ssl-referee"));
  CHECK(has(modules, "ssl-radio"));
  CHECK_FALSE(has(modules, "sim"));
  options.stated_referee = true;  // one publisher per channel: the scenario's word stands
  CHECK_FALSE(has(names(options), "ssl-referee"));
}

TEST_CASE("the viewer comes when asked for, others stay away when asked to") {
  LaunchOptions options;
  options.viewer = true;
  options.left_out = {"planner", "task"};
  CHECK(names(options) == std::vector<std::string>{"sim", "world-model", "controller.Y", "controller.B", "viewer"});
  CHECK(modules_for(options).back().may_end);
  CHECK_FALSE(modules_for(options).front().may_end);
}

TEST_CASE("every module gets bus, scenario and settings, and its team") {
  LaunchOptions options;
  options.lcm_url = "udpm://here";
  options.scenario = "crossing";
  options.settings = {"sim.seed=3", "planner.seed=4"};
  const auto specs = modules_for(options);
  const auto& planner = specs.at(4);
  CHECK(planner.name == "planner.B");
  CHECK(planner.program == "regista-planner");
  CHECK(planner.arguments == std::vector<std::string>{"--lcm-url", "udpm://here", "--config", "crossing", "--set",
                                                      "sim.seed=3", "--set", "planner.seed=4", "--team", "B"});
  CHECK_FALSE(has(specs.at(0).arguments, "--team"));
}

TEST_CASE("a module that dies is started at most once a second") {
  RestartPolicy policy;
  const Time start = from_us(1'000'000'000);
  policy.started(start);
  CHECK(policy.died(start + std::chrono::milliseconds(10)) == start + RestartPolicy::kRestartEvery);
  policy.started(start);
  const Time late = start + std::chrono::minutes(3);
  CHECK(policy.died(late) == late);
}

TEST_CASE("five quick deaths in a row and no more, a long life forgives") {
  RestartPolicy policy;
  const Time start{};
  const auto live = [&](Duration life) {
    policy.started(start);
    return policy.died(start + life);
  };
  const Duration quick = RestartPolicy::kQuickDeath - Duration{1};
  for (int i = 0; i < 4; ++i) CHECK(live(quick).has_value());
  CHECK(live(RestartPolicy::kQuickDeath).has_value());
  for (int i = 0; i < 4; ++i) CHECK(live(quick).has_value());
  CHECK_FALSE(policy.given_up());
  CHECK_FALSE(live(quick).has_value());
  CHECK(policy.given_up());
}

TEST_CASE("the table shows what is known and dashes for the rest") {
  ModuleStatus status;
  status.rate_hz = 99.94;
  status.tick_p50_ns = 123'456;
  status.tick_p99_ns = 2'000'000;
  status.refused = 7;
  const auto lines = table_lines({{"planner.Y", 42, "running", std::chrono::seconds(3723), status, "all well"},
                                  {"sim", {}, "restarting", {}, {}, "no route"}},
                                 200);
  REQUIRE(lines.size() == 3);
  for (const char* text : {"planner.Y", "42", "running", "1:02:03", "99.9", "0.123", "2.000", " 7 ", "all well"}) {
    CHECK_THAT(lines[1], Catch::Contains(text));
  }
  CHECK_THAT(lines[2], Catch::Contains("-") && Catch::Contains("no route"));
  CHECK(lines[0].find("note") == lines[1].find("all well"));
}

TEST_CASE("words of modules cannot steer the terminal, and are cut between characters") {
  CHECK(fit("a\033[2Jb\nc", 100) == "a [2Jb c");
  CHECK(fit("äöü", 2) == "äö");
  CHECK(fit("abc", 0).empty());
}

}  // namespace
}  // namespace regista
