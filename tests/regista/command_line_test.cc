// The `regista` executable: exit statuses, one-line errors, and what needs no running module.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "logs/log_writer.h"
#include "planning/registry.h"
#include "tests/support/program.h"

namespace regista {
namespace {

RunResult regista(std::vector<std::string> arguments, const std::vector<std::string>& variables = {},
                  const std::string& input = "") {
  arguments.insert(arguments.begin(), executable("regista"));
  return run(arguments, variables, input);
}

bool is_one_line(const std::string& text) {
  return !text.empty() && std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n';
}

TEST_CASE("wrong usage is answered in one line and status 2") {
  const std::vector<std::vector<std::string>> wrong{{},
                                                    {"nonsense"},
                                                    {"up", "--nonsense"},
                                                    {"planner"},
                                                    {"planner", "use"},
                                                    {"plan", "x"},
                                                    {"plan", "--planner", "nonsense"},
                                                    {"plan", "--repeat", "0"},
                                                    {"goto", "Y3"},
                                                    {"goto", "Y3", "1", "2", "--release"},
                                                    {"goto", "Y3", "east", "2"},
                                                    {"referee"},
                                                    {"referee", "dance"},
                                                    {"referee", "ball_placement_blue", "1"},
                                                    {"replay"},
                                                    {"replay", "f", "--speed", "0"},
                                                    {"replay", "f", "--into", "nonsense"},
                                                    {"planner", "use", "rrt", "--team", "G"},
                                                    {"param", "set", "sim", "key"},
                                                    {"log"},
                                                    {"log", "compare", "a"},
                                                    {"up", "--for", "-1"}};
  for (const auto& arguments : wrong) {
    const RunResult result = regista(arguments);
    INFO(Catch::StringMaker<std::vector<std::string>>::convert(arguments) << result.error);
    CHECK(result.status == 2);
    CHECK(is_one_line(result.error));
    CHECK(result.out.empty());
  }
}

TEST_CASE("errors that are no usage are one line and status 1") {
  const TemporaryFolder folder;
  std::ofstream(folder.path("exists")) << "x";
  const std::vector<std::vector<std::string>> wrong{
      {"up", "no-such-scenario"},      {"up", "--set", "nonsense"},          {"record", folder.path("exists")},
      {"replay", folder.path("none")}, {"log", "info", folder.path("none")}, {"log", "info", folder.path("")}};
  for (const auto& arguments : wrong) {
    const RunResult result = regista(arguments);
    INFO(result.error);
    CHECK(result.status == 1);
    CHECK(is_one_line(result.error));
  }
}

TEST_CASE("help is help") {
  for (const char* subcommand :
       {"up", "run", "planner", "param", "goto", "referee", "record", "replay", "spy", "log", "plan"}) {
    const RunResult result = regista({subcommand, "--help"});
    CHECK(result.status == 0);
    CHECK(result.out.size() > 50);
  }
}

TEST_CASE("planner list names every planner and what it promises") {
  const RunResult result = regista({"planner", "list"});
  CHECK(result.status == 0);
  for (const PlannerEntry& entry : planners()) {
    CHECK_THAT(result.out, Catch::Contains(std::string(entry.name)) && Catch::Contains(std::string(entry.source)));
  }
}

TEST_CASE("an unknown planner for plan is answered with the list") {
  const RunResult result = regista({"plan", "--planner", "nonsense"});
  for (const PlannerEntry& entry : planners()) CHECK_THAT(result.error, Catch::Contains(std::string(entry.name)));
}

TEST_CASE("plan answers line by line and goes on after nonsense") {
  const std::string good =
      R"({"id":1,"field":{"length":12,"width":9},"start":[-1,0],"goal":[1,0],"radius":0.09,"obstacles":[]})";
  const RunResult result = regista({"plan", "--repeat", "2"}, {}, good + "\r\n\n  \nnonsense\n" + good);
  CHECK(result.status == 0);
  std::istringstream lines(result.out);
  std::vector<std::string> statuses;
  for (std::string line; std::getline(lines, line);) {
    statuses.push_back(nlohmann::json::parse(line)["status"].get<std::string>());
  }
  CHECK(statuses == std::vector<std::string>{"ok", "invalid", "ok"});
}

TEST_CASE("plan says so when its answers cannot be written") {
  const RunResult result = run({"/bin/sh", "-c", "echo nonsense | " + executable("regista") + " plan > /dev/full"});
  CHECK(result.status == 1);
  CHECK_THAT(result.error, Catch::Contains("cannot write"));
}

TEST_CASE("missing programs of other packages are named with their package") {
  const TemporaryFolder folder;
  LogWriter(folder.path("log")).close();
  const std::vector<std::string> no_path{"PATH=" + folder.path("")};
  const std::string bus = private_bus();
  CHECK_THAT(regista({"record", folder.path("new"), "--lcm-url", bus}, no_path).error,
             Catch::Contains("apt-get install liblcm-bin"));
  CHECK_THAT(regista({"replay", folder.path("log"), "--lcm-url", bus}, no_path).error,
             Catch::Contains("apt-get install liblcm-bin"));
  CHECK_THAT(regista({"spy"}, no_path).error, Catch::Contains("apt-get install default-jre"));
}

TEST_CASE("a module that does not run is named with the command that starts it") {
  const std::string bus = private_bus();
  for (const auto& [arguments, start] :
       {std::pair<std::vector<std::string>, std::string>{{"planner", "use", "rrt"}, "regista-planner --team Y"},
        {{"planner", "use", "rrt", "--team", "B"}, "regista-planner --team B"},
        {{"param", "list", "sim"}, "regista-sim"},
        {{"goto", "Y3", "-1.5", "-0.5", "90"}, "regista-task"}}) {
    auto all = arguments;
    all.insert(all.end(), {"--lcm-url", bus});
    const RunResult result = regista(all);
    INFO(result.error);
    CHECK(result.status == 1);
    CHECK(is_one_line(result.error));
    CHECK_THAT(result.error, Catch::Contains(start) && Catch::Contains("regista up"));
  }
}

TEST_CASE("log info and compare print what is there") {
  const TemporaryFolder folder;
  for (const char* name : {"a", "b"}) {
    LogWriter writer(folder.path(name));
    std::vector<std::uint8_t> bytes(20);
    writer.write(Time{}, "SAME", bytes);
    bytes[17] = static_cast<std::uint8_t>(name[0]);
    writer.write(Time{}, "OTHER", bytes);
    writer.close();
  }
  const RunResult info = regista({"log", "info", folder.path("a")});
  CHECK(info.status == 0);
  CHECK_THAT(info.out, Catch::Contains("SAME") && Catch::Contains("2 messages"));
  CHECK(regista({"log", "compare", folder.path("a"), folder.path("b")}).status == 1);
  const RunResult same = regista({"log", "compare", folder.path("a"), folder.path("b"), "--channels", "SAME"});
  CHECK(same.status == 0);
  CHECK_THAT(same.out, Catch::Contains("the logs match"));
}

}  // namespace
}  // namespace regista
