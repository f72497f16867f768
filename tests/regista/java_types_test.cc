// The Java side of the messages: the types jar decodes what C++ encodes, and lcm-spy finds all of them.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "modules/bus/service_values.h"
#include "modules/convert/commands.h"
#include "modules/convert/planning.h"
#include "modules/convert/service.h"
#include "modules/convert/world.h"
#include "tests/support/program.h"
#include "tests/support/virtual_display.h"

namespace regista {
namespace {

const std::string kTypesJar = std::string(REGISTA_BIN_DIR) + "/../regista_types.jar";
const std::string kClassPath = "/usr/share/java/lcm.jar:" + kTypesJar;

template <class Value>
void write(const TemporaryFolder& folder, const std::string& type, const Value& value) {
  const auto bytes = encode(value);
  std::ofstream(folder.path(type), std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

void write_samples(const TemporaryFolder& folder) {
  WorldState world;
  world.captured = from_us(123456789012345);
  world.robots.resize(2);
  world.robots[1].id = {Team::blue, 11};
  world.robots[1].pose.position_m = {-1.25, 2};
  world.ball = BallState{};
  world.ball->velocity_mps = {0, 6.5};
  write(folder, "world_state_t", world);

  RobotPlan plan;
  plan.robot = {Team::yellow, 3};
  plan.target.robot = 3;
  plan.planner = "rrt";
  plan.plan = {PlanStatus::ok, false, true, {{0, 0}, {1, 0.75}}, 1.25, ""};
  write(folder, "plan_t", plan);

  TeamCommands commands;
  commands.commands.resize(1);
  commands.commands[0].wheel_speeds_radps[3] = -40.5;
  write(folder, "commands_t", commands);

  Request request;
  request.id = 77;
  request.verb = "planner.use";
  write(folder, "request_t", request);
}

TEST_CASE("Java decodes what C++ encodes") {
  REQUIRE(std::filesystem::exists(kTypesJar));
  const TemporaryFolder folder;
  write_samples(folder);
  const RunResult compiled = run({"javac", "-cp", kClassPath, "-d", folder.path(""),
                                  std::string(REGISTA_SOURCE_DIR) + "/tests/regista/java/DecodeTypes.java"});
  INFO(compiled.error);
  REQUIRE(compiled.status == 0);
  const RunResult decoded = run({"java", "-cp", kClassPath + ":" + folder.path(""), "DecodeTypes", folder.path("")});
  INFO(decoded.error);
  REQUIRE(decoded.status == 0);
  CHECK(decoded.out ==
        "world 123456789012345 2 -1.25 11 6.5\nplan rrt 2 0.75 true\ncommands 1 -40.5\nrequest 77 planner.use\n");
}

std::size_t types_in_source() {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(REGISTA_SOURCE_DIR) + "/lcmtypes")) {
    if (entry.path().extension() == ".lcm") ++count;
  }
  return count;
}

TEST_CASE("regista spy starts lcm-spy, which finds all our types") {
  const VirtualDisplay display;
  Program spy({executable("regista"), "spy", "--lcm-url", private_bus()}, {"DISPLAY=" + display.name()});
  const std::string found = "Found " + std::to_string(types_in_source()) + " LCM types";
  CHECK(eventually([&] { return (spy.out() + spy.error()).find(found) != std::string::npos; }));
  INFO(spy.out() << spy.error());
  CHECK_THAT(spy.out() + spy.error(), Catch::Contains(found));
  CHECK_THAT(spy.error(), !Catch::Contains("Unrecognized"));
}

}  // namespace
}  // namespace regista
