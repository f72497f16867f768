// Which channels a module publishes, as patterns for a replay.
#include "logs/module_channels.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <regex>

#include "modules/bus/channels.h"

namespace regista {
namespace {

bool is_output(const std::string& module, const std::string& channel) {
  const auto patterns = outputs_of(module);
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& pattern) { return std::regex_match(channel, std::regex(pattern)); });
}

bool plays(const std::vector<std::string>& without, const std::string& channel) {
  return std::regex_match(channel, std::regex(all_but(without)));
}

TEST_CASE("every module's channels are its own") {
  CHECK(is_output("sim", channels::vision().name));
  CHECK(is_output("sim", channels::truth().name));
  CHECK(is_output("sim", channels::geometry().name));
  CHECK(is_output("world-model", channels::world_state().name));
  CHECK(is_output("world-model", channels::timing("world-model").name));
  CHECK(is_output("task", channels::targets(Team::blue).name));
  CHECK(is_output("task", channels::referee().name));
  CHECK(is_output("ssl-referee", channels::referee().name));
  CHECK(is_output("planner.Y", channels::plan({Team::yellow, 11}).name));
  CHECK(is_output("planner.Y", channels::graph(Team::yellow).name));
  CHECK(is_output("planner.Y", channels::status("planner.Y").name));
  CHECK(is_output("controller.B", channels::commands(Team::blue).name));

  CHECK_FALSE(is_output("planner.Y", channels::plan({Team::blue, 11}).name));
  CHECK_FALSE(is_output("planner.Y", channels::status("planner.B").name));
  CHECK_FALSE(is_output("world-model", channels::truth().name));
  CHECK_FALSE(is_output("sim", channels::world_state().name));
}

TEST_CASE("without a team both are meant") {
  CHECK(is_output("planner", "PLAN.Y3"));
  CHECK(is_output("planner", "PLAN.B3"));
  CHECK(is_output("controller", "STATUS.controller.B"));
}

TEST_CASE("unknown modules are answered with the list") {
  for (const char* name : {"", "planer", "planner.", "planner.X", "sim.Y", "PLAN"}) {
    CHECK_THROWS_WITH(outputs_of(name), Catch::Contains("known: sim") && Catch::Contains("planner[.Y|.B]"));
  }
}

TEST_CASE("all but some leaves the others, whole names only") {
  CHECK(plays({}, "VISION"));
  CHECK(plays({"VISION"}, "GEOMETRY"));
  CHECK_FALSE(plays({"VISION"}, "VISION"));
  CHECK(plays({"VISION"}, "VISION2"));
  CHECK(plays({"VISION"}, "MY.VISION"));
  CHECK_FALSE(plays({"A|B", "C.*"}, "B"));
  CHECK_FALSE(plays({"A|B", "C.*"}, "CC"));
  CHECK(plays({"A|B", "C.*"}, "D"));
}

}  // namespace
}  // namespace regista
