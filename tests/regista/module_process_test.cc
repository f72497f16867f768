// One watched child: its words, its end, and that it never outlives its launcher.
#include "modules/regista/module_process.h"

#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>

#include "tests/support/program.h"

namespace regista {
namespace {

TEST_CASE("all lines arrive, the last one even without its end") {
  ModuleProcess process("/bin/sh", {"-c", "echo out; echo error >&2; printf rest"});
  REQUIRE(eventually([&] { return process.end().has_value(); }));
  CHECK(process.read_lines() == std::vector<std::string>{"out", "error", "rest"});
  CHECK(process.end()->text == "ended with status 0");
}

TEST_CASE("it is told how a process ended") {
  ModuleProcess failed("/bin/sh", {"-c", "exit 3"});
  REQUIRE(eventually([&] { return failed.end().has_value(); }));
  CHECK(failed.end()->text == "ended with status 3");

  ModuleProcess killed("/bin/sh", {"-c", "sleep 1000"});
  CHECK_FALSE(killed.end().has_value());
  killed.send(SIGKILL);
  REQUIRE(eventually([&] { return killed.end().has_value(); }));
  CHECK(killed.end()->text == "was killed by signal 9");

  ModuleProcess missing("/no/such/program", {});
  REQUIRE(eventually([&] { return missing.end().has_value(); }));
  CHECK(missing.read_lines() == std::vector<std::string>{"No such file or directory"});
}

TEST_CASE("a signal right after the start is not lost between fork and exec") {
  for (int round = 0; round < 50; ++round) {
    ModuleProcess process("/bin/sh", {"-c", "while :; do sleep 0.05; done"});
    process.send(SIGTERM);
    REQUIRE(eventually([&] { return process.end().has_value(); }));
    REQUIRE(process.end()->text == "was killed by signal 15");
  }
}

TEST_CASE("a line without end fills no memory") {
  ModuleProcess process("/bin/sh", {"-c", "head -c 100000 /dev/zero | tr '\\0' x"});
  std::size_t longest = 0, sum = 0;
  const auto take = [&] {
    for (const std::string& line : process.read_lines()) {
      longest = std::max(longest, line.size());
      sum += line.size();
    }
    return process.end().has_value();
  };
  REQUIRE(eventually(take));
  take();
  CHECK(longest <= 4096);
  CHECK(sum > 90'000);
}

TEST_CASE("destroying it ends it and its own children") {
  const std::string mark = "1000." + std::to_string(getpid());
  {
    ModuleProcess process("/bin/sh", {"-c", "sleep " + mark + " & sleep " + mark});
    REQUIRE(eventually([&] { return processes_with("sleep " + mark).size() >= 2; }));
  }
  CHECK(eventually([&] { return processes_with("sleep " + mark).empty(); }));
}

TEST_CASE("a child has none of the launcher's files open but the three") {
  ModuleProcess process("/bin/sh", {"-c", "readlink /proc/self/fd/0; exec ls /proc/self/fd"});
  REQUIRE(eventually([&] { return process.end().has_value(); }));
  // 3 is the folder that ls reads.
  CHECK(process.read_lines() == std::vector<std::string>{"/dev/null", "0", "1", "2", "3"});
}

}  // namespace
}  // namespace regista
