// Scenarios and parameters: precedence, refusal with advice, and every shipped file loads.
#include "modules/process/config.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "modules/controller/controller_module.h"
#include "modules/lockstep/whole_loop.h"
#include "modules/planner/planner_module.h"
#include "modules/setup/module_setup.h"
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

TEST_CASE("no key of any section is passed over in silence") {
  for (const char* setting : {"sim.yellow.rate=1", "task.speed=1", "viewer.size=1", "world_model.blue.latency_s=0",
                              "scenario.yellow.seed=1", "scenario"}) {
    INFO(setting);
    CHECK_THROWS_AS(Config::load("", {setting}), ConfigError);
  }
  for (const char* setting :
       {"sim.foo=1", "world_model.foo=1", "planner.foo=1", "planner.blue.foo=1", "controller.yellow.foo=1",
        "planner.use=rr", "scenario.foo=1", "scenario.duration_s=-1"}) {
    INFO(setting);
    CHECK_THROWS_AS(check_parameters(Config::load("", {setting})), ConfigError);
  }
  CHECK_NOTHROW(check_parameters(Config::load("", {})));
}

TEST_CASE("an error names where the value came from") {
  const TemporaryFolder folder;
  const std::string file = write(folder, "[planner]\niterations = 7\n");
  PlannerModuleParams params;
  CHECK_THROWS_WITH(Config::load(file, {"planner.seed=x"}).apply("planner", params),
                    Catch::StartsWith("--set planner.seed=x: "));
  const std::string wrong = write(folder, "[planner]\niterations = -7\n");
  CHECK_THROWS_WITH(Config::load(wrong, {}).apply("planner", params), Catch::StartsWith(wrong + ": "));
}

TEST_CASE("what a simulated field is like is known to the estimate and the controller") {
  for (const char* preset : {"none", "noisy", "realistic"}) {
    const Config config = Config::load("", {std::string("scenario.sim_preset=") + preset});
    const SimParams sim = sim_setup_of(config, Time{}).params;
    const WorldModelParams world_model = world_model_params_of(config);
    INFO(preset);
    CHECK(world_model.latency_s == sim.vision.latency_s + sim.radio.latency_s);
    CHECK(world_model.velocity_lag_s == sim.velocity_lag_s);
    CHECK(world_model.robot.position_sigma_m >= sim.vision.robot_sigma_m);
    CHECK(controller_params_of(config, Team::blue).control.drive_lag_s == sim.velocity_lag_s);
  }
  const Config set = Config::load("", {"world_model.latency_s=0.5"});
  CHECK(world_model_params_of(set).latency_s == 0.5);
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
    CHECK_NOTHROW(sim_setup_of(config, Time{}));
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
