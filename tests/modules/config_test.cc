// Scenarios and parameters: precedence, refusal with advice, and every shipped file loads.
#include "modules/process/config.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "modules/controller/controller_module.h"
#include "modules/lockstep/whole_loop.h"
#include "modules/planner/planner_module.h"
#include "modules/sim/sim_setup.h"
#include "tests/support/temporary_folder.h"

using namespace regista;

namespace {

std::string write(const TemporaryFolder& folder, const std::string& text) {
  const std::string file = folder.path("scenario.toml");
  std::ofstream(file) << text;
  return file;
}

}  // namespace

TEST_CASE("file over default, --set over file, team section over section") {
  const TemporaryFolder folder;
  const std::string file = write(folder,
                                 "[planner]\nteam_margin_m = 0.05\niterations = 7\n"
                                 "[planner.blue]\nteam_margin_m = 0.06\n");
  const Config config = Config::load(file, {"planner.iterations=9"});
  PlannerModuleParams yellow;
  config.apply("planner", yellow, "yellow");
  PlannerModuleParams blue;
  config.apply("planner", blue, "blue");
  CHECK(yellow.planning.team_margin_m == 0.05);
  CHECK(blue.planning.team_margin_m == 0.06);
  CHECK(yellow.planning.iterations == 9);
  CHECK(yellow.planning.area_margin_m == PlanningParams{}.area_margin_m);
}

TEST_CASE("what is unknown refuses to start and is told the nearest name") {
  PlannerModuleParams params;
  CHECK_THROWS_WITH(Config::load("", {"planner.team_margn_m=0.1"}).apply("planner", params),
                    Catch::Contains("did you mean 'team_margin_m'"));
  CHECK_THROWS_WITH(Config::load("", {"planer.team_margin_m=0.1"}), Catch::Contains("known sections"));
  CHECK_THROWS_WITH(Config::load("", {"planner.team_margin_m=wide"}).apply("planner", params),
                    Catch::Contains("not a number"));
  CHECK_THROWS_WITH(Config::load("", {"planner.team_margin_m=-1"}).apply("planner", params),
                    Catch::Contains("outside"));
  CHECK_THROWS_WITH(Config::load("", {"planner.team_margin_m"}), Catch::Contains("section.key=value"));
  CHECK(params == PlannerModuleParams{});
}

TEST_CASE("a file that is none is named, with the line") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(Config::load(write(folder, "[planner]\nteam_margin_m = = 1\n"), {}), Catch::Contains(".toml:2"));
  CHECK_THROWS_WITH(scenario_file("no-such-scenario"), Catch::Contains("crossing"));
}

TEST_CASE("every shipped scenario loads into every module's parameters") {
  const std::filesystem::path shipped = std::filesystem::path(REGISTA_SOURCE_DIR) / "modules" / "scenarios";
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(shipped)) {
    INFO(entry.path().string());
    ++count;
    const Config config = Config::load(entry.path().string(), {});
    CHECK_NOTHROW(config.scenario());
    CHECK_NOTHROW(configured_setup(config, Time{}));
    WorldModelParams world_model;
    CHECK_NOTHROW(config.apply("world_model", world_model));
    for (const char* team : {"yellow", "blue"}) {
      PlannerModuleParams planner;
      CHECK_NOTHROW(config.apply("planner", planner, team));
      ControllerModuleParams controller;
      CHECK_NOTHROW(config.apply("controller", controller, team));
    }
  }
  CHECK(count >= 1);
}
