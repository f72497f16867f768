// The launcher against programs that misbehave: shell scripts in the modules' place.
#include "modules/regista/launcher.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "modules/process/real_clock.h"
#include "modules/regista/command.h"
#include "tests/support/program.h"

namespace regista {
namespace {

constexpr Duration kStep = std::chrono::milliseconds(20);

/// A module that is this script; its first flag is a text that makes it findable.
ChildSpec script(const TemporaryFolder& folder, const std::string& name, const std::string& text) {
  const std::string program = "regista-" + name;
  std::ofstream(folder.path(program)) << "#!/bin/sh\n" << text << "\n";
  std::filesystem::permissions(folder.path(program), std::filesystem::perms::owner_all);
  return {name, program, {folder.path(name)}, name == "viewer"};
}

struct Fixture {
  TemporaryFolder folder;
  Bus bus{private_bus(), real_clock()};
  Display display;

  std::vector<pid_t> alive() const { return processes_with(folder.path("")); }
  std::size_t count(const std::string& file) const {
    std::ifstream in(folder.path(file));
    std::size_t lines = 0;
    for (std::string line; std::getline(in, line);) ++lines;
    return lines;
  }
  std::vector<pid_t> pids(const std::string& file) const {
    std::ifstream in(folder.path(file));
    return {std::istream_iterator<pid_t>(in), {}};
  }
};

TEST_CASE_METHOD(Fixture, "what dies is started again, the others are left alone") {
  const auto sim = script(folder, "sim", "echo $$ >> " + folder.path("sim-pids") + "; while :; do sleep 0.05; done");
  const auto task = script(folder, "task", "echo $$ >> " + folder.path("task-pids") + "; while :; do sleep 0.05; done");
  Launcher launcher(bus, {sim, task}, folder.path(""), display);
  REQUIRE(eventually([&] {
    launcher.step(kStep);
    return count("sim-pids") == 1 && count("task-pids") == 1;
  }));
  kill(pids("sim-pids").back(), SIGKILL);
  REQUIRE(eventually([&] {
    launcher.step(kStep);
    return count("sim-pids") == 2;
  }));
  CHECK(is_alive(pids("sim-pids").back()));
  CHECK(count("task-pids") == 1);
  CHECK(is_alive(pids("task-pids").back()));
  CHECK(launcher.given_up() == 0);
  launcher.stop();
  CHECK(eventually([&] { return alive().empty(); }));
}

TEST_CASE_METHOD(Fixture, "a module that cannot run is given up after five quick deaths") {
  const auto sim = script(folder, "sim", "echo start >> " + folder.path("starts") + "; echo 'no field' >&2; exit 1");
  Launcher launcher(bus, {sim}, folder.path(""), display);
  REQUIRE(eventually([&] {
    launcher.step(kStep);
    return launcher.given_up() == 1;
  }));
  CHECK(count("starts") == 5);
  for (int i = 0; i < 100; ++i) launcher.step(kStep);
  CHECK(count("starts") == 5);
}

TEST_CASE_METHOD(Fixture, "a window that was closed stays closed, one that crashed comes back") {
  const auto closed = script(folder, "viewer", "echo start >> " + folder.path("starts") + "; exit 0");
  Launcher launcher(bus, {closed, script(folder, "sim", "echo start >> " + folder.path("sim-starts"))}, folder.path(""),
                    display);
  REQUIRE(eventually([&] {
    launcher.step(kStep);
    return count("sim-starts") >= 3;
  }));
  CHECK(count("starts") == 1);
  CHECK(launcher.given_up() == 0);
}

TEST_CASE_METHOD(Fixture, "modules may end in order, and those that will not are killed") {
  const auto tidy = script(folder, "sim",
                           "trap 'echo end >> " + folder.path("ends") + "; exit 0' TERM; touch " +
                               folder.path("ready1") + "; while :; do sleep 0.05; done");
  const auto stubborn =
      script(folder, "task", "trap '' TERM; touch " + folder.path("ready2") + "; while :; do sleep 0.05; done");
  Launcher launcher(bus, {tidy, stubborn}, folder.path(""), display);
  REQUIRE(eventually([&] {
    launcher.step(kStep);
    return std::filesystem::exists(folder.path("ready1")) && std::filesystem::exists(folder.path("ready2"));
  }));
  launcher.stop();
  CHECK(count("ends") == 1);
  CHECK(eventually([&] { return alive().empty(); }));
}

TEST_CASE_METHOD(Fixture, "a launcher that goes without a word takes its modules with it") {
  {
    Launcher launcher(bus, {script(folder, "sim", "trap '' TERM; while :; do sleep 0.05; done")}, folder.path(""),
                      display);
    REQUIRE(eventually([&] { return !alive().empty(); }));
  }
  CHECK(eventually([&] { return alive().empty(); }));
}

TEST_CASE_METHOD(Fixture, "a module that talks without end is neither blocked nor does it block") {
  Launcher launcher(bus, {script(folder, "sim", "while :; do echo words; done")}, folder.path(""), display);
  for (int i = 0; i < 20; ++i) launcher.step(Duration::zero());
  launcher.stop();
  CHECK(eventually([&] { return alive().empty(); }));
}

TEST_CASE_METHOD(Fixture, "a program that is not there is named before anything is started") {
  const auto sim = script(folder, "sim", "sleep 1000");
  CHECK_THROWS_WITH(Launcher(bus, {sim, {"task", "regista-task", {}}}, folder.path(""), display),
                    Catch::Contains("regista-task") && Catch::Contains("build it"));
  CHECK(eventually([&] { return alive().empty(); }));
}

}  // namespace
}  // namespace regista
