// The `regista` executable told nonsense, in ways that once were taken for something else.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "modules/regista/command_line.h"
#include "tests/support/program.h"

namespace regista {
namespace {

RunResult regista(std::vector<std::string> arguments, const std::string& input = "") {
  arguments.insert(arguments.begin(), executable("regista"));
  return run(arguments, {}, input);
}

bool is_one_line(const std::string& text) {
  return !text.empty() && std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n';
}

TEST_CASE("a query nested without measure is one invalid line, and the rest goes on") {
  const std::string deep = R"({"id":)" + std::string(200'000, '[') + std::string(200'000, ']') + "}";
  const std::string good =
      R"("field":{"length":12,"width":9},"start":[-1,0],"goal":[1,0],"radius":0.09,"obstacles":[]})";
  const RunResult result =
      regista({"plan"}, deep + "\n" + R"({"id":{"a":1},)" + good + "\n" + R"({"id":"b",)" + good + "\n");
  CHECK(result.status == 0);
  std::istringstream lines(result.out);
  std::vector<nlohmann::json> answers;
  for (std::string line; std::getline(lines, line);) answers.push_back(nlohmann::json::parse(line));
  REQUIRE(answers.size() == 3);
  for (const std::size_t i : {0U, 1U}) {
    CHECK(answers[i]["status"] == "invalid");
    CHECK(answers[i]["id"].is_null());
  }
  CHECK_THAT(answers[0]["reason"].get<std::string>(), Catch::Contains("nested deeper than 16"));
  CHECK_THAT(answers[1]["reason"].get<std::string>(), Catch::Contains("id: must be a string or a number"));
  CHECK(answers[2]["status"] == "ok");
  CHECK(answers[2]["id"] == "b");
}

TEST_CASE("an unknown command is named, with those there are") {
  for (const auto& [arguments, known] : {std::pair<std::vector<std::string>, std::string>{{"foo"}, "known: up, run"},
                                         {{"planner", "foo"}, "known: list, use"},
                                         {{"log", "foo", "x"}, "known: info, compare"}}) {
    const RunResult result = regista(arguments);
    CHECK(result.status == 2);
    CHECK(is_one_line(result.error));
    CHECK_THAT(result.error, Catch::Contains("unknown command 'foo'") && Catch::Contains(known));
  }
}

TEST_CASE("planner list takes the flag all of the planner's commands take") {
  CHECK(regista({"planner", "list", "--lcm-url", private_bus()}).status == 0);
}

TEST_CASE("up plays a shipped scenario where none is named, and says which") {
  CHECK_THAT(regista({"up", "--help"}).out, Catch::Contains("crossing"));
}

TEST_CASE("up checks the parameters of all modules before it starts any") {
  for (const char* setting :
       {"planner.nonsense=1", "planner.yellow.use=nonsense", "controller.blue.nonsense=1", "sim.nonsense=1",
        "world_model.nonsense=1", "ssl_vision.port=0", "ssl_referee.port=0", "ssl_radio.nonsense=1"}) {
    const RunResult result = regista({"up", "--for", "0.1", "--lcm-url", private_bus(), "--set", setting});
    INFO(setting << ": " << result.error);
    CHECK(result.status == 1);
    CHECK(is_one_line(result.error));
    CHECK(result.out.empty());
  }
}

TEST_CASE("negative numbers need no leading digit") {
  const RunResult result = regista({"goto", "Y3", "-.5", "-.25e1", "-.9", "--lcm-url", private_bus()});
  CHECK(result.status == 1);
  CHECK_THAT(result.error, Catch::Contains("no answer from task"));
  const char* argv[] = {"regista", "-.5", "-.25e1", "-.5x", "-.", "-x", "--set", "a=-.5"};
  CHECK(arguments_of(8, argv) == std::vector<std::string>{"-0.5", "-0.25e1", "-.5x", "-.", "-x", "--set", "a=-.5"});
}

TEST_CASE("a file without a message is no log to show or to play") {
  const TemporaryFolder folder;
  std::ofstream(folder.path("file")) << "no log";
  for (const auto& arguments :
       {std::vector<std::string>{"log", "info", folder.path("file")}, {"replay", folder.path("file")}}) {
    const RunResult result = regista(arguments);
    CHECK(result.status == 1);
    CHECK(result.out.empty());
    CHECK(is_one_line(result.error));
    CHECK_THAT(result.error, Catch::Contains("no whole message"));
  }
}

TEST_CASE("record says at once where it cannot write, and leaves nothing") {
  const TemporaryFolder folder;
  for (const std::string& file : {folder.path("none/log"), std::string("/proc/log")}) {
    const RunResult result = regista({"record", file, "--lcm-url", private_bus()});
    CHECK(result.status == 1);
    CHECK(is_one_line(result.error));
    CHECK_THAT(result.error, Catch::Contains("cannot write " + file));
  }
  CHECK(regista({"record", folder.path("."), "--force", "--lcm-url", private_bus()}).status == 1);
  CHECK(regista({"record", folder.path("log"), "--lcm-url", "nonsense"}).status == 1);
  CHECK_FALSE(std::filesystem::exists(folder.path("log")));
}

}  // namespace
}  // namespace regista
