// What the launcher takes from the bus: choices for those it restarts, twins, and no more than it can chew.
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "modules/process/real_clock.h"
#include "modules/regista/launcher.h"
#include "tests/support/program.h"

namespace regista {
namespace {

constexpr Duration kStep = std::chrono::milliseconds(20);

std::string content_of(const std::string& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A launcher, on a bus within this process, of one script in the simulator's place, which writes its process id and
/// its flags to files.
struct Fixture {
  TemporaryFolder folder;
  Bus bus{"memq://", real_clock()};
  Display display;

  ChildSpec sim() const {
    const std::string program = folder.path("regista-sim");
    std::ofstream(program) << "#!/bin/sh\necho \"$@\" > " << folder.path("flags") << "\necho $$ >> "
                           << folder.path("pids") << "\nwhile :; do sleep 0.05; done\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    return {"sim", "regista-sim", {folder.path("mark")}};
  }
  std::vector<pid_t> pids() const {
    std::ifstream in(folder.path("pids"));
    return {std::istream_iterator<pid_t>(in), {}};
  }
};

TEST_CASE_METHOD(Fixture, "a module that is started again gets what was chosen at run time") {
  Launcher launcher(bus, {sim()}, folder.path(""), display);
  REQUIRE(eventually([&] { return pids().size() == 1; }));
  bus.publish(channels::request(), Request{bus.now(), 1, "sim", "param.set", "seed", "7"});
  bus.publish(channels::reply(), Reply{bus.now(), 1, true, "sim", "seed = 7"});
  launcher.step(Duration::zero());
  CHECK(content_of(folder.path("flags")) == folder.path("mark") + "\n");
  kill(pids().front(), SIGKILL);
  REQUIRE(eventually([&] {
    launcher.step(kStep);
    return pids().size() == 2;
  }));
  CHECK(content_of(folder.path("flags")) == folder.path("mark") + " --set sim.seed=7\n");
  launcher.stop();
}

TEST_CASE_METHOD(Fixture, "messages without end do not keep the launcher from watching") {
  Launcher launcher(bus, {sim()}, folder.path(""), display);
  constexpr int kEnough = 100'000;
  int handled = 0;
  const Listener<ModuleStatus> echo(bus, channels::statuses(), [&](const ModuleStatus& status) {
    if (++handled < kEnough) bus.publish(channels::status("sim"), status);
  });
  ModuleStatus status;
  status.module = "sim";
  bus.publish(channels::status("sim"), status);
  launcher.step(Duration::zero());
  CHECK(handled > 0);
  CHECK(handled < kEnough);
  launcher.stop();
}

TEST_CASE("a planner beside the launcher's own is told as an event, once") {
  const std::string url = private_bus();
  Program launcher({executable("regista"), "up", "--lcm-url", url});
  Program second({executable("regista-planner"), "--team", "Y", "--config", "crossing", "--lcm-url", url});
  const std::string twice = "runs twice on this bus: also as pid ";
  const auto event = [&] {
    const std::string out = launcher.out();
    const std::size_t at = out.find("planner.Y, pid ");
    return at != std::string::npos && out.find(twice, at) != std::string::npos;
  };
  CHECK(eventually(event));
  INFO(launcher.out());
  const std::string second_pid = "pid " + std::to_string(second.pid());
  CHECK_THAT(launcher.out(), Catch::Contains(second_pid));
  launcher.send(SIGINT);
  CHECK(launcher.wait() == 0);
  const std::string out = launcher.out();
  CHECK(out.find("planner.Y, pid ") == out.rfind("planner.Y, pid "));
}

TEST_CASE("a planner swapped at run time is still the one after a restart") {
  const std::string url = private_bus();
  Program launcher({executable("regista"), "up", "--lcm-url", url});
  const auto planner_pids = [&] { return processes_with("regista-planner --lcm-url " + url); };
  REQUIRE(eventually([&] { return planner_pids().size() == 2; }));
  REQUIRE(eventually([&] {
    return run({executable("regista"), "planner", "use", "rrt", "--team", "Y", "--lcm-url", url}).status == 0;
  }));
  for (const pid_t pid : planner_pids()) {
    if (content_of("/proc/" + std::to_string(pid) + "/cmdline").ends_with(std::string("Y\0", 2))) kill(pid, SIGKILL);
  }
  CHECK(eventually(
      [&] { return launcher.out().find("planner.Y restarted with planner.yellow.use=rrt") != std::string::npos; }));
  REQUIRE(eventually([&] {
    const auto got = run({executable("regista"), "param", "get", "planner.Y", "use", "--lcm-url", url});
    return got.status == 0 && got.out == "rrt\n";
  }));
  launcher.send(SIGINT);
  CHECK(launcher.wait() == 0);
}

}  // namespace
}  // namespace regista
