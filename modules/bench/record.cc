#include "modules/bench/record.h"

#include <ctime>
#include <fstream>
#include <thread>

#include "modules/bench/tool.h"

namespace regista::bench {
namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

/// Of the last minute, when the bench began: single shots are honest only where little else runs.
std::string load() {
  std::ifstream file("/proc/loadavg");
  std::string last_minute = "unknown";
  file >> last_minute;
  return last_minute;
}

/// Of the checkout this program was built from, as it is now.
std::string commit() {
  const ToolResult git =
      run_tool(".", {"git", "-C", REGISTA_CHECKOUT, "describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"});
  return git.status == 0 ? git.output.substr(0, git.output.find('\n')) : "unknown";
}

std::string date() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

}  // namespace

std::string own_command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string command;
  for (std::string word; std::getline(file, word, '\0');) command += (command.empty() ? "" : " ") + word;
  return command;
}

Record record_of(const Run& run) {
  return {{"command", run.command}, {"seed", std::to_string(run.seed)},
          {"machine", processor()}, {"cores", std::to_string(std::thread::hardware_concurrency())},
          {"load", load()},         {"compiler", REGISTA_COMPILER},
          {"flags", REGISTA_FLAGS}, {"build type", REGISTA_BUILD_TYPE},
          {"commit", commit()},     {"date", date()}};
}

}  // namespace regista::bench
